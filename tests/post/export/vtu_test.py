#!/usr/bin/python3
"""The reader of VTK opens the files of `blocks export` and finds the numbers of its CSV.

vtu_test.py PROGRAM SOURCE; skipped without Debian's python3-vtk9.
"""

import csv
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

try:
    from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
    from vtkmodules.vtkIOHDF import vtkHDFReader
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    print("skipped: no python3-vtk9")
    sys.exit(77)

BLOCKS = {"block": ("BlockNumber", 0), "material": ("Material", 0), "fixed": ("Fixed", 0),
          "x": ("Centroid", 0), "y": ("Centroid", 1), "dx": ("Displacement", 0), "vy": ("Velocity", 1),
          "fy": ("Force", 1), "spin": ("Spin", 0), "s22": ("Stress", 3), "mass": ("Mass", 0)}
CONTACTS = {"corner_block": ("CornerBlock", 0), "corner": ("Corner", 0), "edge_block": ("EdgeBlock", 0),
            "edge": ("Edge", 0), "nx": ("Normal", 0), "fx": ("Force", 0), "fy": ("Force", 1),
            "normal_force": ("NormalForce", 0), "shear_force": ("ShearForce", 0), "overlap": ("Overlap", 0)}


def pieces(folder, name):
    """Yields (time, grid) of every data set of a PVD file."""
    for one in xml.parse(folder / name).iter("DataSet"):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(folder / one.get("file")))
        reader.Update()
        grid = reader.GetOutput()
        assert grid.GetFieldData().GetArray("TimeValue").GetValue(0) == float(one.get("timestep"))
        yield float(one.get("timestep")), grid


def compare(folder, collection, table, columns, cell_type):
    rows = csv.DictReader(open(folder / table))
    numbers = 0
    for time, grid in pieces(folder, collection):
        for cell in range(grid.GetNumberOfCells()):
            row = next(rows)
            assert float(row["time"]) == time
            assert grid.GetCellType(cell) == cell_type
            for column, (array, component) in columns.items():
                value = grid.GetCellData().GetArray(array).GetComponent(cell, component)
                assert value == float(row[column]), (time, cell, column, value, row[column])
                numbers += 1
            if cell_type == 1:
                assert grid.GetPoint(cell)[:2] == (float(row["x"]), float(row["y"]))
    assert next(rows, None) is None, f"{collection} has fewer cells than {table} rows"
    assert numbers > 1000, numbers
    print(f"{collection}: {numbers} numbers as in {table}")


def area(grid, cell):
    points = [grid.GetCell(cell).GetPoints().GetPoint(i) for i in range(grid.GetCell(cell).GetNumberOfPoints())]
    return sum(x1 * y0 - x0 * y1 for (x0, y0, _), (x1, y1, _) in zip(points, points[1:] + points[:1])) / 2


def compare_results(folder, first):
    """Compares the first frame of the results file, which every version of VTK reads."""
    reader = vtkHDFReader()
    reader.SetFileName(str(folder / "stack.vtkhdf"))
    assert reader.CanReadFile(str(folder / "stack.vtkhdf"))
    reader.Update()
    grid = reader.GetOutputDataObject(0)
    assert grid.GetNumberOfCells() == first.GetNumberOfCells() > 0
    for name in ("BlockNumber", "Centroid", "Mass"):
        ours, exported = (one.GetCellData().GetArray(name) for one in (grid, first))
        for cell in range(grid.GetNumberOfCells()):
            assert ours.GetTuple(cell) == exported.GetTuple(cell), (name, cell)


def drawn(grid):
    """Returns how many polygons ParaView draws."""
    surface = vtkGeometryFilter()
    surface.SetInputData(grid)
    surface.Update()
    return surface.GetOutput().GetNumberOfPolys()


def check_removed(program, source, folder):
    """A removed block keeps its cell, but nothing is drawn there."""
    deck = Path(source, "decks/stack/stack.deck").read_text().replace("\nMOTION", "\nREMOVE, 13\nMOTION")
    (folder / "fewer.deck").write_text(deck)
    for words in (["run", "fewer.deck", "-q", "--set", "MOTION.dt=0.01"], ["export", "fewer.vtkhdf", "-o", "fewer.pvd"]):
        subprocess.run([program, *words], cwd=folder, check=True, capture_output=True)
    reader = vtkHDFReader()
    reader.SetFileName(str(folder / "fewer.vtkhdf"))
    reader.Update()
    for grid in (reader.GetOutputDataObject(0), next(pieces(folder, "fewer.pvd"))[1]):
        assert grid.GetNumberOfCells() == 13 and drawn(grid) == 12, drawn(grid)
        assert grid.GetCellData().GetArray("Fixed").GetValue(12) == 3


def main():
    program, source = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for words in (["run", f"{source}/decks/stack/stack.deck", "-q"],
                      ["export", "stack.vtkhdf", "-o", "stack.pvd"], ["export", "stack.vtkhdf", "-o", "stack.csv"]):
            subprocess.run([program, *words], cwd=folder, check=True, capture_output=True)
        compare(folder, "stack.pvd", "stack.csv", BLOCKS, 7)
        compare(folder, "stack_contacts.pvd", "stack_contacts.csv", CONTACTS, 1)
        check_removed(program, source, folder)
        compare_results(folder, next(pieces(folder, "stack.pvd"))[1])
        for _, grid in pieces(folder, "stack.pvd"):  # the polygons enclose the areas of the run
            for cell in range(grid.GetNumberOfCells()):
                stored = grid.GetCellData().GetArray("Area").GetValue(cell)
                assert abs(area(grid, cell) / stored - 1) < 1e-9, (cell, area(grid, cell), stored)


main()
