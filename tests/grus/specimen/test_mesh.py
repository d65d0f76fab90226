import struct

import numpy as np
import pytest

from grus.errors import GrusError
from grus.specimen import Mesh, Sphere, Stamp, agglomerate

CUBE_VERTICES = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
CUBE_QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
CUBE_TRIANGLES = np.array([t for a, b, c, d in CUBE_QUADS for t in ((a, b, c), (a, c, d))])


def ball(diameter: float, refinements: int) -> Mesh:
    """Octahedron, refined and blown up; the corners of faces are on the sphere."""
    faces = [
        np.array([[x, 0, 0], [0, y, 0], [0, 0, z]], dtype=float)
        for x in (1, -1)
        for y in (1, -1)
        for z in (1, -1)
    ]
    for _ in range(refinements):
        finer = []
        for a, b, c in faces:
            ab, bc, ca = ((p + q) / np.linalg.norm(p + q) for p, q in ((a, b), (b, c), (c, a)))
            finer += [np.array(t) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
        faces = finer
    vertices = diameter / 2 * np.concatenate(faces)
    return Mesh(vertices, np.arange(len(vertices)).reshape(-1, 3))


def l_prism() -> Mesh:
    """L-shaped column: triangulated outline (0,0)-(3,0)-(3,1)-(1,1)-(1,3)-(0,3), height 1."""
    outline = np.array([[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]], dtype=float)
    floor = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]
    vertices = np.vstack([np.column_stack([outline, np.full(6, z)]) for z in (0.0, 1.0)])
    triangles = floor + [(a + 6, b + 6, c + 6) for a, b, c in floor]
    for i in range(6):
        j = (i + 1) % 6
        triangles += [(i, j, j + 6), (i, j + 6, i + 6)]
    return Mesh(vertices, triangles)  # Facing in all ways: the mesh has to sort that out.


def winding_number(mesh: Mesh, points: np.ndarray) -> np.ndarray:
    """Solid angle of the surface over 4 pi (van Oosterom & Strackee 1983): 1 inside, 0 outside."""
    a, b, c = (mesh.vertices[mesh.triangles[:, k]][None] - points[:, None] for k in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=2) for v in (a, b, c))
    over = (a * np.cross(b, c)).sum(axis=2)
    under = la * lb * lc + (a * b).sum(2) * lc + (b * c).sum(2) * la + (c * a).sum(2) * lb
    return np.arctan2(over, under).sum(axis=1) / (2 * np.pi)


def test_cube_measures():
    cube = Mesh(CUBE_VERTICES * 2e-3 + 5.0, CUBE_TRIANGLES)
    assert cube.measure == pytest.approx(8e-9, rel=1e-9)
    assert cube.bounding_radius == pytest.approx(np.sqrt(3) * 1e-3, rel=1e-9)
    np.testing.assert_allclose(cube.box, [[-1e-3] * 3, [1e-3] * 3], rtol=1e-9)
    assert cube.of_diameter(0.1).equivalent_diameter == pytest.approx(0.1, rel=1e-12)


def test_cube_margin_is_the_distance_from_the_faces():
    cube = Mesh(CUBE_VERTICES, CUBE_TRIANGLES)
    points = np.array([[0.29, 0, 0], [0.31, 0, 0], [0.1, -0.29, 0.29], [0, 0, 0.6]])
    assert cube.contains(points, 0.2).tolist() == [True, False, True, False]


def test_l_prism_is_turned_outwards_and_centred():
    mesh = l_prism()
    assert mesh.measure == pytest.approx(5.0, rel=1e-12)
    np.testing.assert_allclose(mesh.box, [[-1.1, -1.1, -0.5], [1.9, 1.9, 0.5]], atol=1e-12)
    corners = mesh.vertices[mesh.triangles]
    assert np.linalg.det(corners).sum() / 6 == pytest.approx(5.0, rel=1e-12)


@pytest.mark.parametrize("mesh", [l_prism(), ball(2.0, 2)], ids=["l_prism", "ball"])
def test_inside_agrees_with_the_winding_number(mesh):
    low, high = mesh.box * 1.2
    points = low + (high - low) * np.random.Generator(np.random.PCG64(2)).random((4000, 3))
    assert (mesh.contains(points, 0.0) == (winding_number(mesh, points) > 0.5)).all()


def test_fine_ball_agrees_with_the_sphere():
    mesh, sphere = ball(12e-3, 4), Sphere(12e-3)
    assert mesh.measure == pytest.approx(sphere.measure, rel=1e-2)
    points = 12e-3 * (np.random.Generator(np.random.PCG64(3)).random((5000, 3)) - 0.5)
    # The flat faces lie inside the sphere by at most this sagitta.
    sagitta = 0.02e-3
    inner, outer = (sphere.contains(points, 1e-3 + s) for s in (sagitta, 0.0))
    found = mesh.contains(points, 1e-3)
    assert (inner <= found).all() and (found <= outer).all()
    assert inner.sum() > 1000


def test_a_mesh_makes_a_grain():
    specimen = agglomerate(
        ball(12e-3, 2), 0.8e-3, stamp=Stamp(mean=1.5e-3, deviation=0.3e-3), seed=1
    )
    assert specimen.dimension == 3 and specimen.element_count > 100
    reach = np.linalg.norm(specimen.position, axis=1) + specimen.radius
    assert reach.max() <= 6e-3


def stl_text(corners: np.ndarray) -> bytes:
    lines = ["solid cube"]
    for triangle in corners:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex {} {} {}".format(*point) for point in triangle]
        lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid cube\n"]).encode()


def stl_binary(corners: np.ndarray) -> bytes:
    facets = (struct.pack("<12fH", 0, 0, 0, *triangle.ravel(), 0) for triangle in corners)
    return bytes(80) + struct.pack("<I", len(corners)) + b"".join(facets)


def gts(corners: np.ndarray) -> bytes:
    edges = sorted(
        {tuple(sorted(e)) for a, b, c in CUBE_TRIANGLES for e in ((a, b), (b, c), (c, a))}
    )
    number = {edge: index + 1 for index, edge in enumerate(edges)}
    lines = [f"8 {len(edges)} 12 GtsSurface GtsFace GtsEdge GtsVertex", "# corners"]
    lines += ["{} {} {}".format(*vertex) for vertex in CUBE_VERTICES]
    lines += [f"{a + 1} {b + 1}" for a, b in edges]
    for a, b, c in CUBE_TRIANGLES:
        lines.append(" ".join(str(number[tuple(sorted(e))]) for e in ((a, b), (b, c), (c, a))))
    return "\n".join(lines).encode()


@pytest.mark.parametrize(
    "name, content", [("c.stl", stl_text), ("c.STL", stl_binary), ("c.gts", gts)]
)
def test_read_from_file(tmp_path, name, content):
    path = tmp_path / name
    path.write_bytes(content(CUBE_VERTICES[CUBE_TRIANGLES]))
    cube = Mesh.read(path, unit=1e-3)
    assert len(cube.vertices) == 8 and len(cube.triangles) == 12
    assert cube.measure == pytest.approx(1e-9, rel=1e-6)
    points = np.array([[0.2e-3, 0, 0], [0.4e-3, 0, 0], [0.6e-3, 0, 0]])
    assert cube.contains(points, 0.2e-3).tolist() == [True, False, False]


def test_missing_file():
    with pytest.raises(FileNotFoundError, match="mesh file = nowhere.stl: does not exist"):
        Mesh.read("nowhere.stl")


@pytest.mark.parametrize(
    "name, content, message",
    [
        ("m.obj", b"v 0 0 0", "must be a .stl or .gts file"),
        ("m.stl", b"not a surface", "must be a readable surface with triangles"),
        ("m.gts", b"8 18 12\n0 0 0\n", "must be a GTS surface"),
        ("m.gts", b"hello", "must be a GTS surface"),
        ("m.gts", b"", "must be a GTS surface"),
    ],
)
def test_invalid_file(tmp_path, name, content, message):
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(GrusError, match=message):
        Mesh.read(path)


@pytest.mark.parametrize(
    "vertices, triangles, message",
    [
        (CUBE_VERTICES, CUBE_TRIANGLES[:-1], "mesh edges without exactly two triangles = 3: must"),
        (CUBE_VERTICES[:7], CUBE_TRIANGLES, "mesh triangles = out of range: must be 0..6"),
        (CUBE_VERTICES[:, :2], CUBE_TRIANGLES, r"shape of mesh vertices = \(8, 2\)"),
        (CUBE_VERTICES * np.nan, CUBE_TRIANGLES, "mesh vertices = not finite"),
        (CUBE_VERTICES * [1, 1, 0], CUBE_TRIANGLES, "mesh"),
    ],
)
def test_invalid_mesh(vertices, triangles, message):
    with pytest.raises(GrusError, match=message):
        Mesh(vertices, triangles)
