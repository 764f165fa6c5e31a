"""Opens the pages of the gallery in headless Chromium, uses them, and compares what they show with the recordings."""

import argparse
import csv
import os
import time
from pathlib import Path

from .browser import Browser

#: Frames a second that a page must reach by software rendering.
RATE = 30


def rows(path):
    with open(path, newline="") as file:
        found = list(csv.reader(file))
    names = [column.rsplit(" [", 1)[0] for column in found[0]]
    return names, [[float(value) for value in row] for row in found[1:]]


def values_are_those_recorded(page, folder, name):
    """All values of some frames differ from the CSV file by at most the error that the page states."""
    names, recorded = rows(folder / f"{name}.csv")
    assert page.ask("recording.columns.map(it => it.name)") == names
    frames = sorted({0, 1, len(recorded) // 3, len(recorded) // 2, len(recorded) - 1})
    ranges = [max(column) - min(column) for column in zip(*recorded)]
    sizes = [max(map(abs, column)) for column in zip(*recorded)]
    largest = 0.0
    for frame in frames:
        shown = page.ask(f"recording.columns.map(({{ name }}) => recording.value(name, {frame}))")
        for column, (value, expected) in enumerate(zip(shown, recorded[frame])):
            # Half a step; poses of points at rest in a body have the errors of three positions and of four components of
            # a quaternion, at a lever of up to the size of the chain.
            bound = 0.5 * ranges[column] / 65535 + 1e-12 * sizes[column]
            is_pose = ".position." in names[column] or ".orientation." in names[column]
            if is_pose and not names[column].split(".")[-3] == "input":
                bound = 4 * 2 / 65535 * max(1.0, *(size for size, it in zip(sizes, names) if ".position." in it))
            assert abs(value - expected) <= bound, (name, names[column], frame, value, expected, bound)
            if value != expected:
                largest = max(largest, abs(value - expected) / bound)
    print(f"{name}: {len(names)} quantities in {len(frames)} frames as recorded; largest error {largest:.2f} of the bound")


def number(text):
    return float(text.split()[0].replace("−", "-"))


def time_can_be_used(page):
    """Play runs and pauses, the slider and keys move through the frames, a plot is a jump in time."""
    last = page.ask("Number(document.getElementById('slider').max)")
    page.click("#play")
    page.wait("recording.frame > 2")
    assert page.ask("document.getElementById('play').getAttribute('aria-label')") == "Pause"
    page.click("#play")
    stopped = page.ask("recording.frame")
    time.sleep(0.3)
    assert page.ask("recording.frame") == stopped, "the page plays on after a pause"
    x, y = page.middle("#slider", 0.02)
    page.drag((page.middle("#slider", stopped / last * 0.96 + 0.02)[0], y), (page.middle("#slider", 0.6)[0] - page.middle("#slider", stopped / last * 0.96 + 0.02)[0], 0))
    moved = page.ask("recording.frame")
    assert abs(moved / last - 0.6) < 0.06, (moved, last)
    page.click("#view")
    page.key(".", "Period", ".")
    assert page.ask("recording.frame") == moved + 1
    page.key("Home", "Home")
    assert page.ask("recording.frame") == 0
    left, right = page.ask("(() => { const w = document.querySelector('.area').clientWidth; return [58 / w, 1 - 8 / w]; })()")
    page.click(at=page.middle(".area", left + 0.25 * (right - left)))
    assert abs(page.ask("recording.frame") / last - 0.25) < 0.01, page.ask("recording.frame")


def view_can_be_used(page):
    """Drags orbit and pan, the wheel zooms, keys do both."""
    page.click("#fit")
    before = page.ask("recording.camera")
    start = page.middle("#view", 0.5, 0.7)
    page.drag(start, (80, 30))
    turned = page.ask("recording.camera")
    assert turned["yaw"] != before["yaw"] and turned["pitch"] != before["pitch"]
    page.drag(start, (60, -20), modifiers=8)
    panned = page.ask("recording.camera")
    assert panned["target"] != turned["target"] and panned["yaw"] == turned["yaw"]
    page.mouse("mouseWheel", *start, deltaX=0, deltaY=-200)
    page.frames()
    near = page.ask("recording.camera.distance")
    assert near < panned["distance"]
    page.key("ArrowLeft", "ArrowLeft")
    assert page.ask("recording.camera.yaw") != panned["yaw"]
    page.key("-", "Minus", "-")
    assert page.ask("recording.camera.distance") > near
    page.click("#fit")


def wrench_is_shown(page, point):
    """A click on a point in the picture selects it; the table has its force and moment."""
    page.ask("recording.seek(20)")
    page.frames()
    x, y = page.ask(f"recording.project('{point}')")[:2]
    left, top = page.ask("(() => { const { left, top } = document.getElementById('view').getBoundingClientRect(); return [left, top]; })()")
    page.click(at=(left + x, top + y))
    assert page.ask("(s => s.selectedOptions[0].text)(document.getElementById('point'))") == point
    for kind in ("force", "moment"):
        cells = page.ask(f"[...document.querySelectorAll('tr.{kind} td')].map(it => it.textContent)")
        shown = [number(cell) for cell in cells]
        values = [page.ask(f"recording.value('{point}.{kind}.{axis}')") for axis in "xyz"]
        values.append(sum(value * value for value in values) ** 0.5)
        for value, expected in zip(shown, values):
            # Five digits, four if there is an exponent.
            assert abs(value - expected) <= 6e-4 * abs(expected), (kind, shown, values)


def plots_are_added(page, quantity):
    """A quantity is added by its name, shows the value of the frame, and is removed; wrong names are refused."""
    def add(name):
        page.ask(f"(it => {{ it.value = '{name}'; it.form.requestSubmit(); }})(document.getElementById('quantity'))")
        page.frames()
    add("nothing.at.all")
    assert "nothing.at.all" in page.ask("document.getElementById('wrong').textContent")
    add(quantity)
    key = f"document.querySelector('.key[data-name=\"{quantity}\"] b')"
    for frame in (3, 30):
        page.ask(f"recording.seek({frame})")
        text, value = page.ask(f"{key}.textContent"), page.ask(f"recording.value('{quantity}')")
        if text.split()[0] == "0":
            assert abs(value) <= 1.01 * page.ask(f"recording.uncertainty('{quantity}')")
            continue
        factor = {"k": 1e3, "M": 1e6, "m": 1e-3, "µ": 1e-6, "n": 1e-9}.get(text.split()[1][0] if text.split()[1] != "m" else "", 1)
        assert abs(number(text) * factor - value) <= 6e-4 * abs(value) + 1e-12, (text, value)
    painted = page.ask("(c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some(it => it))(document.querySelector('.plot:last-child canvas'))")
    assert painted, "the plot is empty"
    page.ask(f"document.querySelector('.key[data-name=\"{quantity}\"]').click()")
    assert page.ask(f"{key} === null")


def painted(page):
    """Returns the share of the pixels of the picture that have strong colours, unlike the background."""
    return page.ask("""new Promise(done => requestAnimationFrame(() => {
        const view = document.getElementById('view'), copy = document.createElement('canvas');
        [copy.width, copy.height] = [view.width, view.height];
        recording.seek(recording.frame);
        requestAnimationFrame(() => {
            const context = copy.getContext('2d');
            context.drawImage(view, 0, 0);
            const data = context.getImageData(0, 0, copy.width, copy.height).data;
            let count = 0;
            for (let k = 0; k < data.length; k += 4) {
                const colours = [data[k], data[k + 1], data[k + 2]];
                if (Math.max(...colours) - Math.min(...colours) > 60) count++;
            }
            done(count / (copy.width * copy.height));
        });
    }))""")


def picture_is_painted(page):
    """The picture has bodies and arrows."""
    share = painted(page)
    assert share > 0.002, f"only {share:.4%} of the picture is painted"


def meshes_are_drawn(page):
    """Meshes of STL and OBJ files are drawn at their places; the page names the one that is missing, whose body is drawn as
    one without shapes."""
    notes = page.ask("document.getElementById('notes').textContent")
    assert "mesh absent.stl: the file is not in the folder" in notes and "block.stl" not in notes and "wedge.obj" not in notes, notes
    page.ask("['forces', 'moments', 'trails'].forEach(name => { const it = document.getElementById(name); it.value = 'none'; it.dispatchEvent(new Event('input')); })")
    with_meshes = painted(page)
    page.click("#shapes")
    without = painted(page)
    page.click("#shapes")
    # Two blocks of 12 m by 8 m instead of capsules of 15 m by 2.6 m, and a third capsule in both.
    assert with_meshes > 1.5 * without > 0, (with_meshes, without)


def pixels_near(page, places):
    """Returns the brightness of the pixels within 14 of some places of the picture."""
    pixels = [page.ask(f"recording.pixel({list(place)})")[:2] for place in places]
    return page.ask(f"""new Promise(done => {{
        recording.seek(recording.frame);
        requestAnimationFrame(() => requestAnimationFrame(() => {{
            const view = document.getElementById('view'), context = view.getContext('2d'), ratio = view.width / view.clientWidth, sums = [];
            for (const [x, y] of {pixels}) {{
                const data = context.getImageData(Math.round(ratio * (x - 14)), Math.round(ratio * (y - 14)), 28 * ratio, 28 * ratio).data;
                for (let k = 0; k < data.length; k += 4) sums.push(data[k] + data[k + 1] + data[k + 2]);
            }}
            done(sums);
        }}));
    }})""")


def changed_by(page, switch, places):
    """Returns the number of pixels near some places that change a lot if a switch is used; it is used twice."""
    before = pixels_near(page, places)
    page.click(switch)
    after = pixels_near(page, places)
    page.click(switch)
    assert pixels_near(page, places) == before, "the picture is another one after two clicks"
    return sum(abs(a - b) > 3 * 40 for a, b in zip(before, after))


def along(ends, share):
    return [(1 - share) * a + share * b for a, b in zip(*ends)]


def springs_and_axes_are_drawn(page, spring, hinge, count):
    """A spring is drawn between its ends, whose distance is its recorded length; axes of a hinge are drawn at its point, as
    long as they are switched on."""
    page.ask("['forces', 'moments', 'trails'].forEach(name => { const it = document.getElementById(name); it.value = 'none'; it.dispatchEvent(new Event('input')); })")
    for name in ("numbers", "grid"):
        page.click(f"#{name}")
    for frame in (0, 20, 60):
        page.ask(f"recording.seek({frame})")
        ends = page.ask(f"recording.springEnds('{spring}')")
        distance = sum((a - b) ** 2 for a, b in zip(*ends)) ** 0.5
        # The errors of a position and, at an arm of a metre, of four components of a quaternion.
        bound = page.ask(f"recording.uncertainty('{spring}.length')") + 8 / 65535
        assert abs(distance - page.ask(f"recording.value('{spring}.length')")) <= bound, (frame, distance)
    changed = changed_by(page, "#springs", [along(ends, share) for share in (0.35, 0.5, 0.65)])
    assert changed > 60, f"the spring changes {changed} pixels"
    axes = page.ask(f"recording.axes('{hinge}')")
    assert len(axes) == count, axes
    for ends in axes:
        # The parts of the lines outside of the bodies.
        changed = changed_by(page, "#hinges", [along(ends, share) for share in (0, 1)])
        assert changed > 10, f"an axis changes {changed} pixels"


def theme_follows(page, path):
    """The theme is that of the system until the button is used."""
    theme = "document.documentElement.dataset.theme"
    page.open(path, dark=True)
    assert page.ask(theme) == "dark"
    page.click("#theme")
    assert page.ask(theme) == "light"
    page.open(path)
    assert page.ask(theme) == "light"


def rate_of(page, path, seconds=1.5, windows=5):
    """Returns the frames a second while the motion plays: the most of several windows, because other programs may use the
    processor in some of them."""
    page.open(path)
    return max(rate_in_window(page, seconds) for _ in range(windows))


def rate_in_window(page, seconds):
    # A page without a pause between frames: the time passes frame by frame.
    return page.ask(f"""new Promise(done => {{
        const last = Number(document.getElementById('slider').max), start = performance.now();
        let frame = 0, count = 0;
        const next = now => {{
            recording.seek(frame = (frame + 7) % last); count++;
            now - start < {1000 * seconds} ? requestAnimationFrame(next) : done(1000 * count / (now - start));
        }};
        requestAnimationFrame(next);
    }})""")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="the folder that the gallery was written to")
    parser.add_argument("--screenshots", type=Path, help="also write screenshots to this folder")
    options = parser.parse_args()
    folder, page = options.folder, Browser()
    try:
        for name, point, quantity in [("crane", "jib.input", "boom.output.force.y"), ("dog", "fl.shank.input", "fl.knee.effort"),
                                      ("four_bar", "coupler.input", "kinetic_energy"), ("train", "second.input", "first.input.force.x")]:
            page.open(folder / f"{name}.html")
            assert all(url.startswith(("file:", "data:", "blob:")) for url in page.requests), page.requests
            values_are_those_recorded(page, folder, name)
            picture_is_painted(page)
            time_can_be_used(page)
            view_can_be_used(page)
            wrench_is_shown(page, point)
            plots_are_added(page, quantity)
        for path in sorted((folder / "examples").glob("*.html")):
            page.open(path)
            picture_is_painted(page)
            summary = page.ask("document.getElementById('summary').textContent")
            print(f"{path.stem}: {summary}")
        page.open(folder / "meshes.html")
        meshes_are_drawn(page)
        page.open(folder / "dog.html")
        springs_and_axes_are_drawn(page, "harness", "fl.hip", 2)
        theme_follows(page, folder / "crane.html")
        rate = rate_of(page, folder / "tree.html")
        others = os.getloadavg()[0] > (os.cpu_count() or 1)
        excuse = ", not judged because other programs use the processor" if others and rate <= RATE else ""
        print(f"tree: {rate:.0f} frames a second{excuse}")
        assert others or rate > RATE, f"{rate:.1f} frames a second, not more than {RATE}"
        assert not page.errors, page.errors
        if options.screenshots:
            screenshots(page, folder, options.screenshots)
    finally:
        page.close()


def screenshots(page, folder, to):
    to.mkdir(parents=True, exist_ok=True)
    for name in ("crane", "dog", "four_bar", "train", "meshes", "tree"):
        for dark in (False, True):
            page.open(folder / f"{name}.html", dark=dark)
            page.ask("recording.seek(Math.floor(document.getElementById('slider').max / 4))")
            page.frames()
            page.screenshot(to / f"{name}-{'dark' if dark else 'light'}.png")
    page.open(folder / "dog.html", width=420, height=860)
    page.frames()
    page.screenshot(to / "dog-narrow.png")


if __name__ == "__main__":
    main()
