"""Polygons and meshes as grain outlines."""

import math

import pytest

from grus.card import Card

POLYGON = {"agglomerate.outline": "polygon"}
SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
STAR = [
    [math.cos(i * math.pi / 5) / (1 + i % 2), math.sin(i * math.pi / 5) / (1 + i % 2)]
    for i in range(10)
]


@pytest.mark.parametrize(
    "vertices", [SQUARE, SQUARE[::-1], STAR, [[0, 0], [1e6, 0], [0, 1e6]], [(0, 0), (1, 0), (0, 1)]]
)
def test_simple_polygons(plane, vertices):
    card = plane.with_overrides({**POLYGON, "agglomerate.vertices": vertices})
    assert card.agglomerate.vertices == tuple((float(x), float(y)) for x, y in vertices)
    assert Card.from_dict(card.to_dict()) == card


@pytest.mark.parametrize(
    "vertices",
    [
        [],
        SQUARE[:2],
        [[0, 0], [1, 1], [1, 0], [0, 1]],  # bow tie
        [[0, 0], [1, 0], [2, 0]],
        [[0, 0], [1, 0], [2, 1e-9]],
        [[0, 0], [0, 0], [0, 0]],
        [[0, 0], [2, 0], [2, 2], [1, 0], [0, 2]],  # a corner touches a side
        [[0, 0], [1, 0], [1]],
        [[0, 0], [1, 0], [1, 1, 1]],
        [[0, 0], [1, 0], [1, "1"]],
        [[0, 0], [1, 0], [1, True]],
        [[0, 0], [1, 0], [1, float("nan")]],
        [[0, 0], [1, 0], [1, 1e7]],
        [[0, 0], [1, 0], [1, 10**400]],
        [[0, 0], [1, 0], 3],
        [[math.cos(i), math.sin(i)] for i in range(1001)],
        "square",
        {"x": 1},
    ],
)
def test_what_is_no_polygon(plane, refusal, vertices):
    message = refusal(plane.with_overrides, {**POLYGON, "agglomerate.vertices": vertices})
    assert "agglomerate.vertices" in message and "allowed: a list of 3 to 1000 points" in message


def test_vertex_at_fault_is_numbered(plane, refusal):
    vertices = [[0, 0], [1, "0"], [1, 1]]
    message = refusal(plane.with_overrides, {**POLYGON, "agglomerate.vertices": vertices})
    assert "a coordinate of vertex 2 is not a number" in message


def test_path_of_a_mesh_counts_from_the_card(models, tmp_path, monkeypatch, refusal):
    text = (models / "montesinho-3d.toml").read_text()
    text = text.replace('outline = "sphere"', 'outline = "mesh"\nmesh = "shapes/cube.STL"')
    (tmp_path / "card.toml").write_text(text)
    monkeypatch.chdir(tmp_path.parent)
    name = f"{tmp_path.name}/card.toml"
    message = refusal(Card.from_file, name)
    assert f'{name}: agglomerate.mesh = "shapes/cube.STL": no such file' in message
    (tmp_path / "shapes").mkdir()
    (tmp_path / "shapes" / "cube.STL").write_text("solid")
    card = Card.from_file(name)
    assert card.mesh_path == tmp_path / "shapes" / "cube.STL"
    monkeypatch.chdir("/")
    assert card.mesh_path.is_file() and card.with_overrides({"seed": 2}).mesh_path.is_file()
    assert Card.from_dict(card.to_dict()) == card


def test_mesh_must_be_a_file_of_a_known_kind(solid, tmp_path, refusal):
    mesh = {"agglomerate.outline": "mesh"}
    (tmp_path / "a.stl").mkdir()
    (tmp_path / "a.obj").write_text("")
    for name in ("a.stl", "a.obj", "b.gts"):
        path = str(tmp_path / name)
        message = refusal(solid.with_overrides, {**mesh, "agglomerate.mesh": path})
        assert "agglomerate.mesh" in message and "*.stl or *.gts" in message
