"""Draws results and compares the data of the artists, not pixels."""

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import colors
from matplotlib import pyplot as plt
from matplotlib.collections import LineCollection, PolyCollection

import blocks
from blocks import colours, plotting
from blocks.colours import joint_colour
from blocks.figures import math_text
from blocks.force_lines import links_of
from blocks.notebooks import html_of
from blocks.results import read

PROGRAM = os.environ["BLOCKS_PROGRAM"]
DECKS = Path(__file__).parents[2] / "decks"


def run(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("results")
    bare = (DECKS / "stack/stack.deck").read_text().replace("UNITS, m, kg, s\n", "")
    (made / "bare.deck").write_text(bare.replace("A STACK", "A <STACK>"))
    for name, deck, options in (
        ("stack", DECKS / "stack/stack.deck", ()),
        ("cracks", DECKS / "crater_cracks/crater_cracks.deck", ("--until", ".06")),
        ("every", DECKS / "every_card/every_card.deck", ()),
        ("bare", made / "bare.deck", ("--until", ".1")),
    ):
        run("run", deck, "-o", made / name, "--threads", 1, "-q", *options)
    return made


@pytest.fixture(scope="module")
def opened(folder):
    return {path.stem: read(path) for path in folder.glob("*.vtkhdf")}


@pytest.fixture(autouse=True)
def close_figures():
    yield
    plt.close("all")


# --- Blocks


def test_blocks_are_those_of_the_frame(opened):
    for results in opened.values():
        for frame in (results[0], results[-1]):
            drawing = frame.plot()
            assert isinstance(drawing.blocks, PolyCollection) and list(drawing)[0] is drawing.blocks
            paths = drawing.blocks.get_paths()
            assert len(paths) == len(frame)
            for path, polygon in zip(paths, frame.polygons):
                np.testing.assert_array_equal(path.vertices[:-1] if len(polygon) else path.vertices, polygon)
            fixed = np.flatnonzero((frame.fixed != 0) & ~frame.is_removed)
            assert len(drawing.fixed.get_paths()) == len(fixed) > 0
            plt.close(drawing.figure)


def test_axes(opened):
    drawing = opened["cracks"].plot()
    ax, corners = drawing.ax, opened["cracks"][-1].corners
    assert ax.get_aspect() == 1.0
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x [m]", "y [m]")
    margin = 0.03 * np.ptp(corners, axis=0).max()
    np.testing.assert_allclose(ax.get_xlim(), (corners[:, 0].min() - margin, corners[:, 0].max() + margin))
    np.testing.assert_allclose(ax.get_ylim(), (corners[:, 1].min() - margin, corners[:, 1].max() + margin))
    assert drawing.colorbar is None and drawing.legend is None and drawing.forces is None
    assert len(ax.figure.axes) == 1
    assert opened["bare"].plot().ax.get_xlabel() == "x [L]"


def test_axes_of_the_caller(opened):
    figure, ax = plt.subplots()
    ax.set(xlabel="distance", xlim=(0, 1), ylim=(0, 2))
    drawing = opened["stack"].plot(ax=ax)
    assert drawing.ax is ax and drawing.figure is figure
    assert ax.get_xlabel() == "distance" and ax.get_ylabel() == "y [m]"
    assert ax.get_xlim() == (0, 1) and ax.get_ylim() == (0, 2)
    size = figure.get_size_inches().tolist()
    assert size == matplotlib.rcParams["figure.figsize"]
    drawing.remove()
    assert not ax.collections and not ax.texts


def test_time(opened):
    stack = opened["stack"]
    drawing = stack.plot(0.31)
    np.testing.assert_array_equal(drawing.blocks.get_paths()[3].vertices[:-1], stack.at(0.31).polygons[3])
    with pytest.raises(ValueError, match="has times"):
        stack.plot(9.0)


def test_materials_have_the_colours_of_the_program(opened, folder):
    run("plot", folder / "every.vtkhdf", "-o", folder / "every.svg")
    fills = colours_in(folder / "every.svg")
    frame = opened["every"][-1]
    drawn = frame.plot().blocks.get_facecolor()
    for material in (1, 2):
        own = plotting.material_colour(material)
        assert own in fills
        assert {colors.to_hex(c) for c in drawn[frame.is_free & (frame.material == material)]} == {own}
    assert {colors.to_hex(c) for c in drawn[~frame.is_free & ~frame.is_removed]} == {"#e4e4e4"}
    assert plotting.material_colour(41) == plotting.material_colour(1) != plotting.material_colour(9)


def test_chosen_colours_of_materials(opened):
    frame = opened["every"][-1]
    drawn = frame.plot(cmap={"HARD ROCK": "red", 2: "0.5"}, forces=True).blocks.get_facecolor()
    pale = colors.to_hex((0.3 * 1 + 0.7, 0.7, 0.7))
    assert {colors.to_hex(c) for c in drawn[frame.material == 1]} == {pale}
    assert len(np.unique(drawn, axis=0)) == 2


@pytest.mark.parametrize("name, cmap, range_", [
    ("speed", "YlGnBu", "lowest"), ("s22", "RdBu_r", "middle"), ("y", "viridis", "none"),
    ("displacement", "YlGnBu", "lowest"), ("spin", "RdBu_r", "middle"), ("area", "viridis", "none"),
])
def test_quantities(opened, name, cmap, range_):
    frame = opened["cracks"][-1]
    drawing = frame.plot(colour=name, colorbar=True)
    values = frame.quantity(name)
    np.testing.assert_array_equal(drawing.blocks.get_array(), values)
    assert drawing.blocks.get_cmap().name == cmap
    largest = np.abs(values).max()
    wanted = {"lowest": (0, largest), "middle": (-largest, largest), "none": (values.min(), values.max())}
    assert drawing.blocks.get_clim() == wanted[range_]
    label = f"{frame.label(name)} [{frame.unit(name)}]"
    assert math_text(label) in (drawing.colorbar.ax.get_ylabel(), drawing.colorbar.ax.get_xlabel())


def test_arrays(opened):
    frame = opened["stack"][-1]
    n = len(frame)
    values = np.linspace(0, 5, n)
    values[3] = np.nan
    drawn = frame.plot(colour=values, clim=(1, 2), cmap="magma").blocks
    assert drawn.get_clim() == (1, 2) and drawn.get_cmap().name == "magma"
    drawn.update_scalarmappable()
    np.testing.assert_allclose(drawn.get_facecolor()[3], colors.to_rgba("0.85"))
    assert frame.plot(colour=values - 2).blocks.get_clim() == (-3, 3)
    nearly = frame.plot(colour=values - 0.25).blocks  # of nearly one sign
    assert nearly.get_clim() == (-0.25, 4.75)
    np.testing.assert_allclose(nearly.get_cmap()(0.05), matplotlib.colormaps["RdBu_r"](0.5), atol=0.02)
    assert frame.plot(colour=values > 2).blocks.get_clim() == (0, 1)
    norm = colors.LogNorm(1, 10)
    assert frame.plot(colour=values, norm=norm).blocks.norm is norm
    own = np.random.default_rng(1).random((n, 3))
    np.testing.assert_allclose(frame.plot(colour=own).blocks.get_facecolor()[:, :3], own)
    named = ["red", "0.5"] * (n // 2) + ["C0"] * (n % 2)
    np.testing.assert_allclose(frame.plot(colour=named).blocks.get_facecolor(), colors.to_rgba_array(named))
    with pytest.raises(ValueError, match=r"colour has the shape \(4,\), but there are 13 blocks"):
        frame.plot(colour=values[:4])
    with pytest.raises(KeyError, match="no quantity 'sped': choose speed"):
        frame.plot(colour="sped")
    with pytest.raises(ValueError, match="a colour bar needs a quantity"):
        frame.plot(colorbar=True)


def test_one_colour_and_options(opened):
    frame = opened["every"][-1]
    plain = frame.plot(colour=None).blocks
    assert len(np.unique(plain.get_facecolor(), axis=0)) == 1
    chosen = frame.plot(fc="none", ec="red", lw=2, zorder=5, alpha=0.5, label="rock").blocks
    assert chosen.get_facecolor().size == 0 and chosen.get_linewidth().tolist() == [2]
    np.testing.assert_array_equal(chosen.get_edgecolor()[0], colors.to_rgba("red", 0.5))
    assert (chosen.get_zorder(), chosen.get_label()) == (5, "rock")
    over = frame.plot(colour="speed", facecolor="0.9").blocks
    assert over.get_array() is None and colors.to_hex(over.get_facecolor()[0]) == "#e6e6e6"


def test_outlines_contrast_with_the_blocks(opened):
    frame = opened["cracks"][-1]
    for colour in ("material", "speed", "y"):
        drawn = frame.plot(colour=colour).blocks
        ground, line = (colours.luminance(c) for c in (drawn.get_facecolor(), drawn.get_edgecolor()))
        contrast = (np.maximum(ground, line) + 0.05) / (np.minimum(ground, line) + 0.05)
        assert contrast.min() > 1.5


def test_numbers(opened):
    every = opened["every"][-1]
    texts = every.plot(numbers=True).numbers
    assert [text.get_text() for text in texts] == [str(b) for b in range(35)]  # 35 is removed
    np.testing.assert_array_equal(texts[31].get_position(), every.centroid[31])
    small = plt.figure(figsize=(0.8, 0.8)).subplots()
    assert len(every.plot(small, numbers=True).numbers) < 20


def test_legend(opened):
    legend = opened["every"].plot(legend=True).legend
    assert [text.get_text() for text in legend.get_texts()] == ["HARD ROCK", "material 2", "fixed"]


def test_movie(opened):
    """The pictures of a movie are drawn into the same Axes."""
    _, ax = plt.subplots()
    for frame in opened["cracks"]:
        drawing = frame.plot(ax, "speed", forces=True, colorbar=not ax.child_axes, force_scale=1e6)
        artists = len(ax.collections), len(ax.child_axes)
        drawing.remove()
    assert artists == (4, 1) and not ax.collections and not ax.child_axes


# --- Simulations and assemblies


class State:
    """Two squares, the first of them fixed, with one contact: what plot() needs and no more."""

    polygons = [np.array([[x, 0.0], [x, 1.0], [x + 1, 1.0], [x + 1, 0.0]]) for x in (0, 1)]
    centroid = np.array([[0.5, 0.5], [1.5, 0.5]])
    area, material = np.ones(2), np.array([1, 3])
    velocity = np.array([[0.0, 0.0], [3.0, 4.0]])
    stress = np.array([np.zeros((2, 2)), [[5.0, 4.0], [4.0, -1.0]]])
    is_free = np.array([False, True])
    contacts = np.array(
        [(1, 0, (1.0, 0.25), (3.0, -4.0))],
        [("corner_block", "i4"), ("edge_block", "i4"), ("point", "f8", 2), ("force", "f8", 2)],
    )

    def __len__(self):
        return 2


def test_any_object_with_outlines():
    state = State()
    drawing = plotting.plot(state, forces=True, legend=True, numbers=True)
    assert colors.to_hex(drawing.blocks.get_facecolor()[0]) == "#e4e4e4"
    assert len(drawing.fixed.get_paths()) == 1
    assert [text.get_text() for text in drawing.legend.get_texts()] == ["material 3", "fixed"]
    assert [text.get_text() for text in drawing.numbers] == ["0", "1"]
    np.testing.assert_array_equal(drawing.forces.get_segments(), [[(1.5, 0.5), (1.0, 0.25)]])
    assert drawing.forces.get_array() == [5.0] and drawing.ax.get_xlabel() == "x [L]"
    values = {"speed": 5, "velocity": 5, "vy": 4, "s22": -1, "p1": 7, "p2": -3, "is_free": 1}
    for name, value in values.items():
        assert plotting.plot(state, colour=name).blocks.get_array().tolist() == [0, value]
    with pytest.raises(KeyError, match="no quantity 'displacement': choose speed, x, y, vx, vy, p1"):
        plotting.plot(state, colour="displacement")
    state.is_removed = np.array([True, False])
    drawing = plotting.plot(state, forces=True)
    assert len(drawing.blocks.get_paths()[0].vertices) == 0 and drawing.fixed is None
    assert plotting.picture(state).startswith(b"\x89PNG")


@pytest.mark.parametrize("name, clim, zero", [("s11", (0, 5), 0.0), ("s22", (-1, 0), 1.0), ("s12", (0, 4), 0.0)])
def test_values_of_one_sign_have_half_of_the_map(name, clim, zero):
    """Zero keeps the colour in the middle, and the bar has no half without values."""
    drawn = plotting.plot(State(), colour=name).blocks
    assert drawn.get_clim() == clim and drawn.get_cmap().name == "RdBu_r"
    np.testing.assert_allclose(drawn.get_cmap()(zero), matplotlib.colormaps["RdBu_r"](0.5), atol=0.02)
    own = plotting.plot(State(), colour=name, cmap="PuOr").blocks
    assert own.get_clim() == (-max(map(abs, clim)), max(map(abs, clim))) and own.get_cmap().name == "PuOr"
    assert plotting.plot(State(), colour=name, clim=(-9, 9)).blocks.get_cmap()(0.5) == drawn.get_cmap()(zero)


def test_simulations(fall):
    simulation = blocks.Simulation(fall)
    simulation.run_until(1.2, read=True)
    drawing = simulation.plot(forces=True)
    before = [path.vertices.copy() for path in drawing.blocks.get_paths()]
    np.testing.assert_array_equal(before[2][:-1], simulation.polygons[2])
    assert len(drawing.forces.get_segments()) == 2 and len(drawing.fixed.get_paths()) == 1
    weight = 9.81 * simulation.mass[2]
    np.testing.assert_allclose(drawing.forces.get_array(), [weight, 2 * weight], rtol=0.02)
    assert plotting.force_scale([simulation]) == drawing.forces.get_array()[-1]
    speed = simulation.plot(colour="speed")
    kept, lines = speed.blocks.get_array().copy(), np.concatenate(drawing.forces.get_segments())
    simulation.set_velocity(2, (1.0, 0.0))
    simulation.step(10, read=False)
    for old, path in zip(before, drawing.blocks.get_paths()):
        np.testing.assert_array_equal(path.vertices, old)
    np.testing.assert_array_equal(speed.blocks.get_array(), kept)
    np.testing.assert_array_equal(np.concatenate(drawing.forces.get_segments()), lines)
    assert simulation.plot(colour="speed").blocks.get_array()[2] > 0.5
    for name in ("spin", "mass", "y", "s11", "force"):
        simulation.plot(colour=name, colorbar=True)
    with pytest.raises(blocks.NotReadError):
        simulation.plot(forces=True)
    page = html_of(simulation)
    assert "BOXES FALL ON A FLOOR" in page and "&lt;Simulation" in page and "image/png" in page


def test_assemblies():
    assembly = blocks.layers([(0, 0), (0, 1), (8, 1), (8, 0)], 9)
    drawing = assembly.plot(colour="layer", colorbar=True, numbers=True)
    assert drawing.blocks.get_array().tolist() == [1] * 9 and drawing.fixed is None
    assert drawing.colorbar.ax.get_xlabel() == "layer"
    assert len(assembly.plot(colour=np.arange(9)).blocks.get_paths()) == 9
    with pytest.raises(ValueError, match="no contact forces in <Assembly"):
        assembly.plot(forces=True)
    with pytest.raises(KeyError, match="no quantity 'speed': choose x, y, mass, area"):
        assembly.plot(colour="speed")
    assert plotting.picture(assembly).startswith(b"\x89PNG")


# --- Contact forces


def test_forces_carry_the_weight(opened):
    """In the column of aligned bricks, 2 to 7, each joint carries the bricks above it."""
    frame = opened["stack"][-1]
    drawing = frame.plot(forces=True, force_width=6.0)
    links = links_of(frame)
    weight = frame.mass[1] * 10
    in_column = {
        (first, second): force
        for first, second, force in zip(links.first, links.second, links.force)
        if 0 <= first < second <= 6
    }
    assert set(in_column) == {(k, k + 1) for k in range(6)}
    for (first, _), force in in_column.items():
        assert force == pytest.approx((6 - first) * weight, rel=1e-3)
    assert isinstance(drawing.forces, LineCollection)
    np.testing.assert_allclose(drawing.forces.get_linewidths(), 6.0 * links.force / links.force[-1])
    np.testing.assert_array_equal(drawing.forces.get_array(), links.force)
    assert drawing.forces.get_clim() == (0, links.force[-1])
    for first, second, segment, point in zip(
        links.first, links.second, drawing.forces.get_segments(), links.point
    ):
        ends = [frame.centroid[b] for b in (first, second) if frame.fixed[b] == 0]
        np.testing.assert_array_equal(segment, [ends[0], point, *ends[1:]])
    assert len(drawing.rims.get_segments()) == len(links.force) == 12
    assert drawing.rims.get_linewidths()[-1] == 6.7  # the line and 0.7 pt
    thin = frame.plot(forces=True, force_width=0.25)
    assert not np.any(thin.rims.get_linewidths())


def test_links_sum_all_contacts(opened):
    for name in ("stack", "cracks", "every"):
        for frame in opened[name]:
            links = links_of(frame)
            assert np.all(np.diff(links.force) >= 0)
            pairs = {tuple(sorted(pair)) for pair in zip(
                frame.contacts["corner_block"].tolist(), frame.contacts["edge_block"].tolist()
            )}
            assert set(zip(links.first.tolist(), links.second.tolist())) <= pairs
            for first, second, point, force in zip(*links):
                total, weights, places = np.zeros(2), 0.0, np.zeros(2)
                for one in frame.contacts:
                    corner, edge = one["corner_block"], one["edge_block"]
                    if {corner, edge} == {first, second}:
                        total += one["force"] if corner == first else -one["force"]
                        size = np.hypot(*one["force"])
                        weights, places = weights + size, places + size * one["point"]
                assert force == pytest.approx(np.hypot(*total), rel=1e-9)
                np.testing.assert_allclose(point, places / weights)
            if name != "stack":
                break


def test_one_scale_for_several_frames(opened):
    frames = opened["stack"][2:]
    scale = plotting.force_scale(frames)
    largest = [links_of(frame).force[-1] for frame in frames]
    assert scale == np.median(largest)
    for frame in frames[:3]:
        forces = frame.plot(forces=True, force_scale=scale, force_width=4).forces
        widths = 4 * np.minimum(forces.get_array() / scale, 1.5)
        np.testing.assert_allclose(forces.get_linewidths(), widths)
        assert forces.get_clim() == (0, scale)
    assert plotting.force_scale([opened["stack"][0]]) == 0.0


def test_without_contacts(opened):
    drawing = opened["stack"][0].plot(forces=True, colorbar=True)
    assert drawing.forces.get_segments() == [] and "contact force [N/m]" in drawing.colorbar.ax.get_xlabel()
    drawing.figure.canvas.draw()


# --- Histories


def test_history(opened):
    history = opened["every"].history
    lines = history.plot()
    assert [line.get_label() for line in lines] == list(history.names)
    for line in lines:
        np.testing.assert_array_equal(line.get_xdata(), history["t"])
        np.testing.assert_array_equal(line.get_ydata(), history[line.get_label()])
    upper, lower = lines[0].figure.axes  # energy above two lines of y
    assert [line.axes for line in lines] == [upper, lower, lower]
    assert lower.get_ylabel() == "y [m]" and lower.get_xlabel() == "time [s]"
    assert upper.get_ylabel().replace("\n", " ").replace("\xa0", " ") == "kinetic energy [J/m]"
    assert upper.get_legend() is None and len(lower.get_legend().get_texts()) == 2


def test_history_in_axes_of_the_caller(opened):
    history = opened["cracks"].history
    _, ax = plt.subplots()
    (line,) = history.plot("cracks", ax, color="red", label="seed 1", linewidth=3)
    assert line.axes is ax and line.get_color() == "red" and line.get_label() == "seed 1"
    assert ax.get_ylabel() == "cracks"
    _, ax = plt.subplots()
    history.plot(["energy:cracks", "energy:residual"], ax)
    assert ax.get_ylabel() == "energy [J/m]"
    _, axes = plt.subplots(3)
    assert [line.axes for line in history.plot(ax=axes)] == list(axes)
    with pytest.raises(ValueError, match="3 kinds of quantities, but 2 Axes"):
        history.plot(ax=axes[:2])
    with pytest.raises(KeyError, match="recorded are cracks"):
        history.plot("y:3")
    with pytest.raises(ValueError, match="no HISTORY card"):
        opened["stack"].history.plot()


def test_band():
    times = np.arange(4.0)
    values = np.arange(11.0)[:, None] * [1, 2, 3, 4]
    values[5:, 3] = np.nan
    band = plotting.plot_band(times, values, color="green", label="11 seeds")
    np.testing.assert_allclose(band.line.get_ydata(), [5, 10, 15, 8])
    corners = band.area.get_paths()[0].vertices
    for time, low, high in zip(times, (1, 2, 3, 1.6), (9, 18, 27, 14.4)):
        own = corners[corners[:, 0] == time, 1]
        assert (own.min(), own.max()) == (pytest.approx(low), pytest.approx(high))
    assert band.line.get_label() == "11 seeds"
    np.testing.assert_allclose(band.area.get_facecolor()[0], colors.to_rgba("green", 0.25))
    wider = plotting.plot_band(times, values, band.line.axes, low=0, high=100)
    assert wider.area.get_paths()[0].vertices[:, 1].max() == 30
    one = plotting.plot_band(times, values[3])
    np.testing.assert_array_equal(one.line.get_ydata(), values[3])
    values[:, 2] = np.nan  # no run has a number
    assert np.isnan(plotting.plot_band(times, values).line.get_ydata()[2])
    with pytest.raises(ValueError, match=r"values have the shape \(11, 4\)"):
        plotting.plot_band(times[:3], values)
    with pytest.raises(ValueError, match="0 <= low < high <= 100"):
        plotting.plot_band(times, values, low=90, high=10)


# --- Style


def test_figures_of_one_column(opened):
    before = dict(matplotlib.rcParams)
    with plotting.style():
        for drawing in (
            opened["stack"].plot(forces=True, numbers=True, legend=True),
            opened["stack"].plot(colour="speed", colorbar=True),
            opened["cracks"].plot(colour="s22", colorbar=True, legend=True),
            opened["every"].plot(),
            opened["every"].history.plot()[0],
            plotting.plot_band([0, 1], [[1, 2], [3, 5]]).line,
        ):
            figure = drawing.figure
            figure.canvas.draw()
            width, height = figure.get_size_inches() * 25.4
            assert width == pytest.approx(84.0, abs=0.01) and 20 < height < 125
            box = figure.get_tightbbox()  # [in] nothing is cut off, and no edge is empty
            edges = np.array([box.x0, box.y0, width / 25.4 - box.x1, height / 25.4 - box.y1])
            assert edges.min() > 0.0 and edges.max() < 0.1
            for ax in figure.axes:
                for text in (ax.xaxis.label, *ax.get_xticklabels(), *ax.get_yticklabels()):
                    assert text.get_size() >= 7.0
    assert dict(matplotlib.rcParams) == before
    with plotting.style(174, 60):
        assert np.array(matplotlib.rcParams["figure.figsize"]) * 25.4 == pytest.approx([174, 60])


def test_a_pdf_is_one_column_wide(opened, tmp_path):
    with plotting.style():
        opened["stack"].plot(forces=True).figure.savefig(tmp_path / "a.pdf")
    data = (tmp_path / "a.pdf").read_bytes()
    width = float(re.search(rb"/MediaBox \[ ?0 0 ([\d.]+)", data)[1])
    assert width == pytest.approx(84 / 25.4 * 72, abs=0.01)
    assert b"/Type3" not in data and b"/CIDFontType2" in data


def to_lab(rgb):
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    xyz = linear @ np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]).T
    f = np.cbrt(xyz / [0.9505, 1.0, 1.089])
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=1)


# Machado, Oliveira and Fernandes 2009, severity 1: protanopia, deuteranopia, tritanopia.
BLIND = {
    "none": np.eye(3),
    "protan": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216],
               [-0.003882, -0.048116, 1.051998]],
    "deutan": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413],
               [-0.011820, 0.042940, 0.968881]],
    "tritan": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602],
               [0.004733, 0.691367, 0.303900]],
}


@pytest.mark.parametrize("kind", BLIND)
def test_colours_of_lines_differ_for_every_reader(kind):
    with plotting.style():
        cycle = matplotlib.rcParams["axes.prop_cycle"].by_key()["color"]
    rgb = np.array([colors.to_rgb(colour) for colour in cycle])
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    seen = np.clip(linear @ np.array(BLIND[kind]).T, 0, 1)
    seen = np.where(seen <= 0.0031308, 12.92 * seen, 1.055 * seen ** (1 / 2.4) - 0.055)
    lab = to_lab(seen)
    gaps = np.linalg.norm(lab[:, None] - lab[None], axis=2)[np.triu_indices(len(lab), 1)]
    assert len(cycle) == 8 and gaps.min() > 17.0


# --- Notebooks


def test_notebooks(opened):
    figures = plt.get_fignums()
    for shown in (opened["bare"], opened["bare"][0], opened["cracks"].history):
        assert shown._repr_png_().startswith(b"\x89PNG")
    page = opened["bare"]._repr_html_()
    assert "A &lt;STACK&gt; OF BRICKS" in page and "&lt;Results bare.vtkhdf: 2 frames" in page
    assert 'src="data:image/png;base64,iVBOR' in page
    assert "&lt;Frame 0 of bare.vtkhdf" in opened["bare"][0]._repr_html_()
    assert opened["stack"].history._repr_png_() is None
    assert plt.get_fignums() == figures  # nothing is shown twice


def test_representation(opened):
    assert repr(opened["stack"].plot()) == "<Drawing: 13 blocks>"
    assert repr(opened["stack"].plot(forces=True)) == "<Drawing: 13 blocks, 12 force lines>"


def test_pyplot_is_not_needed_for_notebooks(folder):
    code = (
        "import sys; from blocks.results import read; read(sys.argv[1])._repr_png_()\n"
        "assert 'matplotlib.pyplot' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code, folder / "stack.vtkhdf"], check=True)


def test_sides_have_the_colours_of_joints_and_bonds(folder):
    run("run", DECKS / "cohesive_slope/cohesive_slope.deck", "-o", folder / "slope", "--until", ".05", "-q")
    frame = read(folder / "slope.vtkhdf")[-1]
    sides = frame.plot(colour="joint", legend=True).sides
    marked = int(np.count_nonzero(frame.joint))
    assert len(sides.get_segments()) == len(frame.corners) + marked > len(frame.corners)
    assert colors.to_hex(sides.get_colors()[-1]) in {joint_colour(one) for one in np.unique(frame.joint) if one}
    bonds = frame.plot(colour="bond")
    middles = [segment.mean(axis=0) for segment in bonds.sides.get_segments()[len(frame.corners):]]
    assert middles and bonds.sides in list(bonds)
    low, high = frame.corners.min(axis=0), frame.corners.max(axis=0)
    assert all((low <= middle).all() and (middle <= high).all() for middle in middles)


def colours_in(svg):
    """Returns the colours of a picture of the program."""
    text = svg.read_text()
    parts = re.findall(r"rgb\(([\d.]+)%, ?([\d.]+)%, ?([\d.]+)%\)", text)
    return {colors.to_hex([float(x) / 100 for x in one]) for one in parts} | set(re.findall(r"#[0-9a-f]{6}", text))


@pytest.mark.parametrize("colour, deck, until", [("joint", "cohesive_slope", ".05"), ("bond", "direct_shear", ".3")])
def test_colours_of_sides_are_those_of_the_program(folder, colour, deck, until):
    run("run", DECKS / deck / f"{deck}.deck", "-o", folder / colour, "--until", until, "-q")
    run("plot", folder / f"{colour}.vtkhdf", "--colour", colour, "-o", folder / f"{colour}.svg")
    frame = read(folder / f"{colour}.vtkhdf")[-1]
    drawing = frame.plot(colour=colour, legend=True)
    drawn = {colors.to_hex(one) for one in drawing.sides.get_colors()[len(frame.corners):]}
    assert drawn and drawn <= colours_in(folder / f"{colour}.svg")
    if colour == "bond":
        failed = frame.contacts["failed"][frame.contacts["law"] != 0]
        labels = {text.get_text() for text in drawing.legend.get_texts()}
        assert ("failed" in labels) == bool(failed.any())


def test_faces_have_the_colours_of_their_motion(folder):
    run("run", DECKS / "slope/slope.deck", "-o", folder / "sliding", "-q")
    frame = read(folder / "sliding.vtkhdf").at(1.0)
    ends, opening, shear = blocks._blocks._face_motions(frame.results.path, frame.index)
    assert ends.shape == (len(opening), 2, 2, 2) and opening.shape == shear.shape
    assert shear.min() < -0.5 < 0.05 < opening.max()  # the slope slides to the left
    for colour, values in (("opening", opening), ("shear_displacement", shear)):
        drawing = frame.plot(colour=colour, colorbar=True)
        shown = drawing.sides.get_array().compressed()
        assert len(shown) == 2 * 8 * len(values)  # two sides with eight parts
        assert np.isclose(np.abs(shown).max(), np.abs(values).max(), rtol=0.1)
        assert colour.replace("_", " ") in drawing.colorbar.ax.get_ylabel() + drawing.colorbar.ax.get_xlabel()
    limited = frame.plot(colour="opening", clim=(-0.01, 0.01))
    assert limited.sides.get_clim() == (-0.01, 0.01)
    with pytest.raises(ValueError, match="since the first frame of results"):
        blocks.check(DECKS / "slope/slope.deck").plot(colour="opening")


def test_faces_of_broken_contacts_are_left_out(folder):
    """Contacts of planes, and of blocks and corners that are not there, have no face."""
    corners = np.array([(0, 0), (0, 1), (1, 1), (1, 0), (0, 1), (0, 2), (1, 2), (1, 1)], float)
    kinds = [("corner_block", "i4"), ("corner", "i4"), ("edge_block", "i4"), ("edge", "i4"), ("law", "i4"),
             ("bonded", "i4"), ("failed", "i4"), ("slip", "f8")]
    rows = [(1, 4, 0, 1, 3, 1, 0, 0.0), (1, 7, 0, 1, 3, 1, 1, -0.5), (1, 4, 0, 1, 0, 0, 0, 0.0),
            (1, 4, -1, 0, 3, 0, 0, 0.0), (7, 4, 0, 1, 3, 0, 0, 0.0), (1, 99, 0, 1, 3, 0, 0, 0.0)]
    parts, bonds, slips = blocks._blocks._face_parts(corners, [0, 4, 8], np.array(rows, kinds))
    assert bonds == ["bonded", "weakened"] and slips.tolist() == [0.0, 0.5]
    assert parts.tolist() == [[[0, 1], [0.5, 1]], [[1, 1], [0.5, 1]]]


def test_sides_without_joints_or_laws_are_refused(opened):
    for colour, reason in (("joint", "no side of a block has a joint id"), ("bond", "no contact has the law")):
        with pytest.raises(ValueError, match=reason):
            opened["stack"][-1].plot(colour=colour)
