"""Recordings and their pages, from Python and in a notebook."""

import csv
import html
import io
import re

import numpy as np
import pytest
from mstmm_robots import CartPole, Hyq, Recording

H, N = 1e-2, 40


def motion():
    model = CartPole(bob_mass=0.3)
    x = model.initial()
    x[1] = 0.4
    u = np.random.default_rng(5).normal(size=(N, 1))
    return model, model.rollout(x, u, H, N), u


def test_a_recording_has_the_results_of_solve():
    model, states, u = motion()
    recording = model.record(states, u, H, velocities=True)
    held = np.concatenate([u, u[-1:]])
    solution = model.solve(states, held)
    assert len(recording) == N + 1 and "41 frames" in repr(recording)
    # The same functions compute both, so the bits are equal; the time is a product.
    np.testing.assert_array_equal(recording["time"], H * np.arange(N + 1))
    np.testing.assert_array_equal(recording["kinetic_energy"], solution["kinetic_energy"])
    arrays = recording.arrays()
    names = list(arrays["point_names"])
    assert names == list(model.points)
    for block in ("position", "velocity", "force", "moment"):
        for index, name in enumerate(names):
            np.testing.assert_array_equal(arrays[block][:, index], solution["points"][name][block], err_msg=f"{name} {block}")
    np.testing.assert_array_equal(arrays["inputs"], held)
    index = recording.columns.index("bob.input.force.y")
    assert recording.columns.units[index] == "N"
    np.testing.assert_array_equal(recording["bob.input.force.y"], arrays["force"][:, names.index("bob.input"), 1])


def test_states_are_added_one_by_one():
    model, states, u = motion()
    one_by_one = Recording(model)
    for k, x in enumerate(states):
        one_by_one.record(x, u[min(k, N - 1)], k * H)
    together = model.record(states, u, H)
    for name in together.columns:
        np.testing.assert_array_equal(one_by_one[name], together[name], err_msg=name)
    # The recording keeps the parameters it began with.
    model.bob_mass = 0.9
    before = one_by_one["potential_energy"][-1]
    one_by_one.record(states[-1], u[-1], N * H + H)
    assert one_by_one["potential_energy"][-1] == before


def test_files_are_those_of_numpy_and_csv(tmp_path):
    model, states, u = motion()
    recording = model.record(states, u, H)
    recording.write_npz(tmp_path / "motion.npz")
    recording.write_csv(tmp_path / "motion.csv")
    arrays, own = np.load(tmp_path / "motion.npz"), recording.arrays()
    for name, values in own.items():
        np.testing.assert_array_equal(arrays[name], values, err_msg=name)
    head, *rows = csv.reader(io.StringIO((tmp_path / "motion.csv").read_text()))
    assert head == [f"{name} [{unit}]" for name, unit in zip(recording.columns, recording.columns.units)]
    table = np.array(rows, np.float64)
    np.testing.assert_array_equal(table[:, head.index("pole.angle [rad]")], states[:, 1])


def test_pages_and_pictures(tmp_path):
    model, states, u = motion()
    recording = model.record(states, u, H)
    recording.write_html(tmp_path / "motion.html", title="A <pole>")
    page = (tmp_path / "motion.html").read_text()
    assert page.startswith("<!doctype html>") and "<title>A &lt;pole&gt;</title>" in page
    assert '"gravity":[0.0,-9.81,0.0]' in page, "weights are drawn"
    recording.write_svg(tmp_path / "still.svg", -1)
    picture = (tmp_path / "still.svg").read_text()
    assert picture == recording.svg(N) != recording.svg(0) and picture.startswith("<svg") and " N</text>" in picture
    # A floating base: its coordinates and the orientations of points are quaternions.
    robot = Hyq().record(Hyq().initial())
    assert len(robot) == 1 and robot.html().startswith("<!doctype html>")
    np.testing.assert_allclose(np.linalg.norm(robot.arrays()["orientation"], axis=2), 1, rtol=1e-14)


def test_errors_name_what_is_wrong(tmp_path):
    model, states, _ = motion()
    empty = Recording(model)
    with pytest.raises(ValueError, match="call `record` first"):
        empty.html()
    with pytest.raises(IndexError, match="0 frames"):
        empty.svg()
    with pytest.raises(KeyError, match="`columns` lists all"):
        empty["pole.force"]
    with pytest.raises(ValueError, match="time is missing"):
        empty.record(states)
    with pytest.raises(ValueError, match="41 states need 41 times, not 2"):
        empty.record(states, None, [0.0, 1.0])
    with pytest.raises(ValueError, match=r"x must have the shape \(4,\) or \(rows, 4\)"):
        empty.record(np.zeros(3))
    wrong = states.copy()
    wrong[3, 2] = np.nan
    with pytest.raises(FloatingPointError, match="row 3: `rail.velocity` is not finite"):
        empty.record(wrong, None, H * np.arange(len(wrong)))
    assert len(empty) == 3, "the frames before are recorded"
    with pytest.raises(OSError):
        empty.write_csv(tmp_path / "no" / "folder.csv")


NOTEBOOK = """
import numpy as np
from mstmm_robots import CartPole
model = CartPole()
x = model.initial()
x[1] = 0.5
model.record(model.rollout(x, None, 1e-2, 20), None, 1e-2)
"""


def test_a_notebook_shows_the_page():
    nbclient, nbformat = pytest.importorskip("nbclient"), pytest.importorskip("nbformat")
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(NOTEBOOK)])
    done = nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    (output,) = done.cells[0].outputs
    assert "21 frames" in output.data["text/plain"]
    shown = output.data["text/html"]
    (inner,) = re.fullmatch(r'<iframe srcdoc="([^"]*)" style="[^"]*" allowfullscreen></iframe>', shown).groups()
    page = html.unescape(inner)
    model = CartPole()
    x = model.initial()
    x[1] = 0.5
    assert page == model.record(model.rollout(x, None, 1e-2, 20), None, 1e-2).html()
