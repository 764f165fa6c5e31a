"""The examples, by the commands on their pages, and the numbers that their pages state."""

import re
import xml.etree.ElementTree

import numpy as np
import pyarrow.parquet
import pytest
from pages import ALL, load, run


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("neighbours")


def numbers(pattern, text):
    found = re.findall(pattern, text)
    assert found, f"no {pattern} in\n{text}"
    return found


def is_page(path):
    text = path.read_text()
    assert text.startswith("<!doctype html>") and len(text) > 50_000, path
    return text


def is_picture(path, *texts):
    xml.etree.ElementTree.parse(path)
    text = path.read_text()
    assert all(it in text for it in texts), path
    return text


def test_the_ur5_holds_still_and_its_joints_carry_what_is_outboard(folder):
    copy, printed = run("ur5", folder)
    ((moved, fallen),) = numbers(r"the joints move by (\S+) rad in 2 s, without compensation by (\S+) rad", printed)
    # The torques are exact up to rounding, some 1e-13 N m; the arm falls from this pose at rates up to 10/s, so that in 2 s
    # errors grow at most by e^20 / 100. Measured: below 1e-11.
    assert float(moved) < 1e-9 and float(fallen) > 0.1
    forces = numbers(r"(\w+) +force +(\S+) N +weight outboard +(\S+) N", printed)
    assert [link for link, _, _ in forces] == [
        "shoulder_link", "upper_arm_link", "forearm_link", "wrist_1_link", "wrist_2_link", "wrist_3_link"]
    for _, force, weight in forces:
        assert abs(float(force) - float(weight)) < 2e-5 and float(weight) > 1
    ((energy, change),) = numbers(r"kinetic energy (\S+) J, which changes by (\S+) J", printed)
    # The error of RK4 at 1 ms, of order h^4, with torques held over a step, of order h: 1e-3 of the energy.
    assert float(change) < 1e-2 * float(energy)
    page = is_page(copy / "ur5.html")
    assert page.count('"corners":') == 6 and '"note":' not in page, "the page contains all meshes"
    picture = is_picture(copy / "ur5.svg", "<path", " N</text>", " N·m</text>")
    # The largest force is that in the first joint, whose weight the picture states with three digits.
    assert f"{float(forces[0][2]):.0f} N" in picture


def test_the_pole_is_up_from_new_starts(folder):
    copy, printed = run("swing_up", folder)
    ((up, starts),) = numbers(r"(\d+) of (\d+) new starts", printed)
    assert int(starts) == 100 and int(up) >= 95, printed
    is_page(copy / "swing_up.html")
    is_picture(copy / "swing_up.svg", "<path")
    # The policy that is stored does it, and one that does nothing does not.
    learn = load("swing_up", "learn.py")
    weights = np.load(copy / "weights.npy")
    starts = learn.starts(np.random.default_rng(77), 16)
    _, states = learn.episodes(weights[None], starts, 1000)
    assert learn.balanced(states).sum() >= 15
    _, states = learn.episodes(np.zeros_like(weights)[None], starts, 1000)
    assert not learn.balanced(states).any()


def test_learning_is_repeatable(folder):
    learn = load("swing_up", "learn.py")
    first, second, other = (learn.learn(seed, 3, report=print) for seed in (4, 4, 5))
    assert np.array_equal(first, second) and not np.array_equal(first, other)


def test_intervals_of_the_calibration_contain_the_truth(folder):
    copy, printed = run("calibration", folder)
    calibrate = load("calibration", "calibrate.py")
    rows = numbers(r"(\w+) +(\S+) ± (\S+) \S+ +\(true: (\S+)\)", printed)
    assert {name: float(true) for name, _, _, true in rows} == calibrate.TRUE
    for name, value, half, true in rows:
        assert abs(float(value) - float(true)) <= float(half) + 1e-5, (name, value, half)
        assert float(half) < 0.01 * float(true), "known within a percent"
    (noise,) = numbers(r"residuals: (\S+) mrad", printed)
    # 1203 residuals, 10 unknowns: the standard deviation is known within 1 / sqrt(2 * 1193), here four times this.
    assert abs(float(noise) - 1.0) < 4 / np.sqrt(2 * 1193)
    # The derivatives are exact: central differences of step d have errors of 1e-13 / NOISE / d and d^2.
    fit = calibrate.Fit(copy / "motion.csv")
    unknown = np.array([1.7, 0.07, 0.7, 1.0, 0.01, 1.55, -0.02, 0.1, -0.1, 0.05])
    jacobian = fit.jacobian(unknown)
    for column in range(len(unknown)):
        change = 1e-6 * np.eye(len(unknown))[column]
        difference = (fit.residuals(unknown + change) - fit.residuals(unknown - change)) / 2e-6
        np.testing.assert_allclose(jacobian[:, column], difference, atol=1e-5 * np.abs(jacobian[:, column]).max())


def test_intervals_contain_the_truth_as_often_as_they_should(folder):
    """95 % intervals of four parameters in 20 experiments: 76 of 80 with a standard deviation of 2, here three of them."""
    calibrate = load("calibration", "calibrate.py")
    hits = 0
    for seed in range(20):
        path = folder / "motion.csv"
        calibrate.record(seed, path)
        names, values, halves, _ = calibrate.calibrate(path)
        found = {name: (value, half) for name, value, half in zip(names, values, halves)}
        hits += sum(abs(found[name][0] - true) <= found[name][1] for name, true in calibrate.TRUE.items())
    print(f"{hits} of 80 intervals contain the truth")
    assert hits >= 70


def test_a_thousand_winds(folder):
    copy, printed = run("gantry", folder, [("--samples 1000 --chunk 50", "--samples 60 --chunk 10 --workers 2")])
    count = 1000 if ALL else 60
    assert re.search(rf"^swing_after +{count} ", printed, re.MULTILINE) and "sha256 " in printed
    is_picture(copy / "results" / "results.svg")
    is_page(copy / "gantry.html")
    parts = [pyarrow.parquet.read_table(path) for path in sorted((copy / "results").glob("part-*.parquet"))]
    values = {name: np.concatenate([part[name].to_numpy() for part in parts]) for name in parts[0].column_names}
    assert len(values["swing"]) == count and all(np.isfinite(values[name]).all() for name in values)
    # In calm air the hook carries at least the load, and in wind more; the swing after the move grows with the wind.
    assert (values["hook_force"] > 9.81 * values["load_mass"]).all()
    rank = lambda it: np.argsort(np.argsort(it))
    correlation = np.corrcoef(rank(values["mean_wind"] ** 2 / values["load_mass"]), rank(values["swing_after"]))[0, 1]
    assert correlation > 0.5, correlation


def test_the_wind_has_the_spectrum_it_should():
    """Mean and standard deviation of the wind over an hour are those asked for."""
    winds = load("gantry", "winds.py")
    time = np.arange(0, 3600, 0.25)
    # The waves have the part of Kaimal's spectrum from 0.003 to 0.5 Hz; the integral of 4 L / (1 + 6 f L)^(5/3) over all
    # frequencies is one.
    length = winds.SCALE / 12.0
    integral = [-(1 + 6 * f * length) ** (-2 / 3) for f in (0.003, 0.5)]
    share = integral[1] - integral[0]
    for seed in range(3):
        speed = winds.wind(12.0, 0.15, seed, time)
        # The slowest waves have ten periods in the hour; bands are a fifth of an octave wide and their middle is geometric.
        assert abs(speed.mean() - 12) < 0.2 and abs(speed.std() / (0.15 * 12 * np.sqrt(share)) - 1) < 0.1


def test_the_load_is_at_rest_after_a_move_in_calm_air():
    winds = load("gantry", "winds.py")
    calm = {"mean_wind": [0.0], "turbulence": [0.1], "load_mass": [12e3], "gusts": [1.0]}
    results = winds.simulate(calm)
    assert results["swing_after"][0] < 0.2 < results["swing"][0]


def test_the_trolley_moves_and_the_load_arrives():
    """The recorded motion of the trolley is the one that is prescribed; without wind the load ends below it, up to the swing
    that is left."""
    winds = load("gantry", "winds.py")
    model, states, given = winds.motion({"mean_wind": [0.0], "turbulence": [0.1], "load_mass": [12e3], "gusts": [1.0]}, 0)
    points = model.solve(states, given)["points"]
    time = winds.STEP * winds.EVERY * np.arange(len(states))
    np.testing.assert_allclose(points["trolley.input"]["position"][:, 0], winds.trolley(time)[0], atol=1e-12)
    np.testing.assert_allclose(points["trolley.input"]["velocity"][:, 0], winds.trolley(time)[1], atol=1e-12)
    # The rate is the derivative of the position: central differences have an error of h^2 / 6 times the third derivative.
    position, rate, acceleration = winds.trolley(time)
    h = time[1] - time[0]
    for values, derivative in ((position, rate), (rate, acceleration)):
        error = np.abs((values[2:] - values[:-2]) / (2 * h) - derivative[1:-1])
        inner = np.abs(time[1:-1] - winds.MOVE) > h
        assert error[inner].max() < h**2
    assert abs(points["load.input"]["position"][-1, 0] - winds.DISTANCE) < 0.2
