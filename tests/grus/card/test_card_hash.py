"""The content hash: what changes a result changes it, what does not, does not."""

import hashlib

import pytest

from grus.card import Card


def turned(table):
    """The same table, keys in the opposite order."""
    items = reversed(table.items())
    return {key: turned(value) if isinstance(value, dict) else value for key, value in items}


@pytest.mark.parametrize(
    "overrides",
    [
        {"name": "another name", "description": "another\ntext"},
        {"description": None},
        {"element.radius": "0.06 cm", "agglomerate.diameter": "12600 um"},
        {"element.radius": "600e-6 m", "element.density": "2.052 g/cm^3"},
        {"agglomerate.diameter": "  0.0126   m "},
        {"contact.normal_stiffness": "3 GN/m", "contact.shear_stiffness": "3000 N/um"},
        {"bond.tensile_strength": "10 bar", "bond.friction_angle": "0 rad"},
        {"contact.friction_coefficient": 0.50, "bond.radius_ratio": 1},
        {"thickness": None, "seed": None, "bond.radius_ratio": None, "crush.damping": None},
        {"crush.end_drop": 0.9, "agglomerate.stamp_split": False},
        {"crush.platen_friction": 0.5},
        {"bond.scatter": {"kind": "none"}},
        {"agglomerate.missing_fraction": -0.0},
    ],
)
def test_cosmetics_do_not_count(plane, overrides):
    assert plane.with_overrides(overrides).content_hash() == plane.content_hash()


def test_order_of_keys_does_not_count(plane, written):
    assert Card.from_dict(turned(written)).content_hash() == plane.content_hash()


@pytest.mark.parametrize(
    "overrides",
    [
        {"seed": 2},
        {"element.radius": "0.6000000001 mm"},
        {"thickness": "2 m"},
        {"contact.normal_stiffness": "3e9 Pa", "contact.shear_stiffness": "3e9 Pa"},
        {"bond.grain_scatter": {"modulus": 4}},
        {"agglomerate.leftover": "single"},
        {"agglomerate.outline": "polygon", "agglomerate.vertices": [[0, 0], [1, 0], [0, 1]]},
        {"crush.platen_friction": 0.4},
        {"crush.platen_stiffness": "3e10 N/m"},
    ],
)
def test_what_changes_a_result_counts(plane, overrides):
    changed = plane.with_overrides(overrides)
    assert changed.content_hash() != plane.content_hash() and changed != plane


def test_hash_is_that_of_the_canonical_text():
    card = Card.from_dict(
        {
            "name": "a",
            "dimension": 3,
            "element": {"radius": "1 mm", "density": "2 g/cm^3"},
            "contact": {
                "normal_stiffness": "1 GPa",
                "shear_stiffness": "0 Pa",
                "friction_coefficient": 0,
            },
            "bond": {"kind": "none"},
            "agglomerate": {"outline": "sphere", "diameter": "1 cm"},
            "crush": {"speed": "1 mm/s"},
        }
    )
    canonical = (
        '{"agglomerate":{"diameter":"0.01 m","leftover":"single","missing_fraction":0.0,'
        '"outline":"sphere","random_orientation":true,"stamp_deviation":"0.0 m",'
        '"stamp_share":1.0,"stamp_split":false},'
        '"bond":{"friction_angle":"0.0 rad","kind":"none","scatter":{"kind":"none"}},'
        '"contact":{"friction_coefficient":0.0,"law":"linear","normal_stiffness":"1000000000.0 Pa",'
        '"rolling_friction":0.0,"rolling_stiffness":0.0,"shear_stiffness":"0.0 Pa",'
        '"unloading_ratio":1.0},'
        '"crush":{"control":"speed","damping":0.2,"end_drop":0.9,"loop":"GrainLoop","max_strain":0.2,"peak_drop":0.5,'
        '"platen_friction":0.0,"record_interval":0.0001,"speed":"0.001 m/s",'
        '"time_step_safety":0.5},'
        '"dimension":3,"element":{"density":"2000.0 kg/m^3","radius":"0.001 m"},"seed":1}'
    )
    assert card.content_hash() == hashlib.sha256(canonical.encode()).hexdigest()


def test_mesh_counts_by_its_content(solid, tmp_path):
    hashes = []
    for folder, content in (("a", "solid x"), ("b", "solid x"), ("c", "solid y")):
        (tmp_path / folder).mkdir()
        mesh = tmp_path / folder / f"{folder}.stl"
        mesh.write_text(content)
        overrides = {"agglomerate.outline": "mesh", "agglomerate.mesh": str(mesh)}
        hashes.append(solid.with_overrides(overrides).content_hash())
    assert hashes[0] == hashes[1] != hashes[2]
