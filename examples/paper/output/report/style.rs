//! The style sheet of the page, for light and dark screens of any width, and for paper.

pub const STYLE: &str = "
:root {
    color-scheme: light dark;
    --page: #ffffff; --text: #1a1a1a; --faint: #595959; --line: #d0d0d0; --stripe: #f5f5f5;
    --link: #0b5cad; --good: #116329; --bad: #b00020; --body: #dce9f5; --mark: #b34700;
}
@media (prefers-color-scheme: dark) {
    :root {
        --page: #16181b; --text: #e6e6e6; --faint: #a8a8a8; --line: #43474d; --stripe: #1e2125;
        --link: #7fb7f2; --good: #6fcf8e; --bad: #ff7b8a; --body: #24405c; --mark: #ff9d5c;
    }
}
body {
    font: 1rem/1.5 system-ui, sans-serif; color: var(--text); background: var(--page);
    max-width: 70rem; margin: 0 auto; padding: 1rem 1rem 4rem;
}
h1 { font-size: 1.6rem; line-height: 1.25; }
h2 { font-size: 1.3rem; line-height: 1.3; margin: 2.5rem 0 0.5rem; border-top: 1px solid var(--line); padding-top: 1rem; }
h3 { font-size: 1.08rem; margin: 2rem 0 0.3rem; }
p { max-width: 46rem; }
a { color: var(--link); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.875rem; margin: 0.4rem 0; }
th, td { padding: 0.18rem 0.55rem; text-align: right; white-space: nowrap; }
th { font-weight: 600; }
th:first-child, td:first-child { text-align: left; padding-left: 0.3rem; }
tbody th { font-weight: 400; position: sticky; left: 0; background: var(--page); }
tbody tr:nth-child(even) th { background: var(--stripe); }
table.verdicts tbody th { position: static; background: none; }
thead th { white-space: normal; vertical-align: bottom; }
thead tr { border-bottom: 1px solid var(--faint); }
tbody tr:nth-child(even) { background: var(--stripe); }
.number { font-variant-numeric: tabular-nums; }
sup { line-height: 0; font-size: 0.75em; }
table.verdicts { width: 100%; }
table.verdicts td:first-child { white-space: normal; min-width: 15rem; padding-left: 0.3rem; }
table.verdicts tbody tr { background: none; }
table.verdicts tr.section th { font-weight: 600; padding-top: 0.7rem; white-space: normal; }
table.verdicts tr:not(.section) { border-bottom: 1px solid var(--line); }
.passed { color: var(--good); font-weight: 600; }
.failed { color: var(--page); background: var(--bad); font-weight: 700; padding: 0 0.4em; border-radius: 3px; }
.measured { color: var(--faint); }
@media (max-width: 42rem) {
    tbody th { white-space: normal; max-width: 9rem; }
    table.verdicts tbody th { max-width: none; }
    table.verdicts, table.verdicts tbody { display: block; }
    table.verdicts thead { display: none; }
    table.verdicts tr.section, table.verdicts tr.section th { display: block; text-align: left; }
    table.verdicts tr:not(.section) {
        display: grid; grid-template-columns: 9.5rem 1fr auto; padding: 0.3rem 0;
    }
    table.verdicts td { text-align: left; padding: 0.1rem 0.3rem; }
    table.verdicts td:nth-last-child(2) { grid-row: 1; grid-column: 3; text-align: right; }
    table.verdicts td:first-child { grid-row: 1; grid-column: 1 / 3; min-width: 0; }
    table.verdicts td.bound::before { content: '≤ '; }
    table.verdicts td:last-child { text-align: right; grid-column: 3; }
}
figure { margin: 1.5rem 0; }
figcaption { font-size: 0.9rem; max-width: 46rem; margin: 0.4rem 0; }
.plot svg { display: block; width: 100%; max-width: 800px; min-width: 560px; height: auto; }
.drawings { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(19rem, 100%), 1fr)); gap: 1.5rem; }
.drawings figure { margin: 0; }
.drawings a { text-decoration: none; }
.drawings svg { display: block; width: 100%; height: auto; }
details { font-size: 0.9rem; margin: 0.3rem 0 1.5rem; }
summary { cursor: pointer; color: var(--faint); }
nav ol { padding-left: 1.2rem; } nav li { margin: 0.15rem 0; } nav ul { font-size: 0.9rem; padding-left: 1rem; }
.top { font-size: 0.85rem; }
@media print { details > ul { display: block; } .scroll { overflow: visible; } figure { break-inside: avoid; } }
";
