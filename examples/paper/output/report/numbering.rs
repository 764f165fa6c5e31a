//! The numbers of figures and tables on the page.

use crate::section::Section;

/// The figures and tables so far.
#[derive(Default)]
pub struct Numbering {
    entries: Vec<Entry>,
    figures: usize,
    tables: usize,
}

/// A numbered figure or table.
pub struct Entry {
    pub section: Section,
    /// The target of links.
    pub id: String,
    /// "Figure S1"; S as in supplement, because the paper has its own figures.
    pub label: String,
    pub title: String,
    /// The file of a figure.
    file_name: Option<&'static str>,
}

impl Numbering {
    pub fn add_figure(&mut self, section: Section, file: &'static str, title: &str) -> &Entry {
        self.figures += 1;
        let number = self.figures;
        self.add(section, "Figure", number, title, Some(file))
    }

    pub fn add_table(&mut self, section: Section, title: &str) -> &Entry {
        self.tables += 1;
        let number = self.tables;
        self.add(section, "Table", number, title, None)
    }

    fn add(
        &mut self,
        section: Section,
        kind: &str,
        number: usize,
        title: &str,
        file_name: Option<&'static str>,
    ) -> &Entry {
        let index = self.entries.len();
        self.entries.push(Entry {
            section,
            id: format!("{}-s{number}", kind.to_lowercase()),
            label: format!("{kind} S{number}"),
            title: title.to_owned(),
            file_name,
        });
        &self.entries[index]
    }

    /// Returns the figure in this file.
    pub fn figure(&self, file_name: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.file_name == Some(file_name))
    }

    pub fn of_section(&self, section: Section) -> impl Iterator<Item = &Entry> {
        self.entries.iter().filter(move |entry| entry.section == section)
    }
}
