"""Links instead of a matrix, and patches that are smaller where the light changes fast."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from glsim import radiosity
from glsim.radiosity.adapt import refined
from glsim.radiosity.factors import Factors
from glsim.radiosity.formfactors import FormFactors
from glsim.radiosity.gather import gathered, radiosity_at
from glsim.radiosity.hierarchy import Links, linked
from glsim.radiosity.mesh import mesh_of, outline
from glsim.radiosity.methods import compute
from glsim.radiosity.patches import Patches
from glsim.radiosity.quadtree import divided
from glsim.radiosity.rays import Rays
from glsim.radiosity.scene import Scene, SceneError
from glsim.radiosity.scenes import BUILT_IN
from glsim.radiosity.solvers import solved
from glsim.radiosity.subdivide import subdivide
from glsim.radiosity.tree import Tree, tree_of, tree_over
from tests.radiosity.helpers import hall


def scene(name: str) -> Scene:
    return BUILT_IN[name].make().checked()


@pytest.fixture(scope="module")
def tree() -> Tree:
    """The closed Cornell box, about 3000 elements below 200 roots."""
    return tree_over(subdivide(scene("cornell-closed"), 200), 25.0)


@pytest.fixture(scope="module")
def links(tree: Tree) -> Links:
    return linked(tree)


@pytest.fixture(scope="module")
def matrix(links: Links) -> FormFactors:
    return compute(links.patches)


# ---------------------------------------------------------------- the tree


def test_a_trees_parts_are_the_whole(tree: Tree) -> None:
    nodes, parents = tree.nodes, np.flatnonzero(tree.child >= 0)
    children = tree.child[parents, None] + np.arange(4)
    assert len(tree.levels) > 3
    assert len(parents) > 100
    assert nodes.area[children].sum(axis=1) == pytest.approx(nodes.area[parents], rel=1e-12)
    assert (tree.parent[children] == parents[:, None]).all()
    assert nodes.normal[children] == pytest.approx(np.repeat(nodes.normal[parents, None], 4, axis=1), abs=1e-9)


def test_pull_and_push(tree: Tree) -> None:
    """Pulling keeps the power of the whole, and what is even has no moments; a linear function at the roots arrives at
    the elements as it is."""
    nodes, leaves = tree.nodes, tree.leaves
    B = np.random.default_rng(1).uniform(size=(len(leaves), 3))
    roots = slice(0, tree.levels[1])
    means, moments = tree.pulled(B)
    assert nodes.area[roots] @ means[roots] == pytest.approx(nodes.area[leaves] @ B, rel=1e-12)
    assert np.abs(moments[roots]).max() > 0.1
    assert tree.pulled(np.ones_like(B))[1] == pytest.approx(0.0, abs=1e-9)
    H, slopes = np.zeros((len(nodes), 3)), np.zeros((len(nodes), 3, 3))
    slope = np.array([[1.0, 2.0, 3.0], [0.0, 0.0, 0.0], [-2.0, 0.5, 1.0]])
    H[roots], slopes[roots] = nodes.center[roots] @ slope.T, slope
    assert tree.pushed(H, slopes) == pytest.approx(nodes.center[leaves] @ slope.T, abs=1e-9)


# ---------------------------------------------------------------- links


def deviation(B: np.ndarray, true: np.ndarray, patches: Patches) -> tuple[float, float]:
    """Root mean square and bias of B - E, by area, relative to its own."""
    A, reflected = patches.area[:, None], true - patches.E
    rms = np.sqrt((A * (B - true) ** 2).sum() / (A * reflected**2).sum())
    return float(rms), float((A * (B - true)).sum() / (A * reflected).sum())


def test_links_are_the_matrix_in_short(links: Links, matrix: FormFactors) -> None:
    B = solved(matrix)[-1].B
    steps = solved(links, "cg")
    rms, bias = deviation(steps[-1].B, B, links.patches)
    assert len(links.S) < 0.3 * np.count_nonzero(np.triu(matrix.S))
    assert rms < 0.002
    assert abs(bias) < 0.0005
    assert steps[-1].balance == pytest.approx(1.0, abs=1e-4)
    assert links.row_sums == pytest.approx(matrix.row_sums, abs=0.03)


def test_a_lower_accuracy_needs_fewer_links(tree: Tree, links: Links, matrix: FormFactors) -> None:
    B = solved(matrix)[-1].B
    few = linked(tree, 1e-3)
    assert len(few.S) < 0.5 * len(links.S)
    worse, better = (deviation(solved(found, "cg")[-1].B, B, links.patches)[0] for found in (few, links))
    assert better < worse


def test_links_that_must_be_exact_are_the_matrix() -> None:
    """With no unevenness allowed all ends are elements, but where what hides one is certain."""
    tree = tree_over(subdivide(scene("cornell-closed"), 60), 140.0)
    links = linked(tree, 1e-12)
    S = compute(links.patches).S
    rows = np.array([links.row(i) for i in range(len(links.patches))])
    assert rows == pytest.approx(S / links.patches.area[:, None], abs=0.01)
    assert rows.sum(axis=1) == pytest.approx(links.row_sums, rel=1e-9)


def test_links_are_symmetric(links: Links) -> None:
    """x . S y = y . S x: reciprocity."""
    x, y = np.random.default_rng(2).uniform(size=(2, len(links.patches), 3))
    assert (x * links.times(y)).sum() == pytest.approx((y * links.times(x)).sum(), rel=1e-12)


def test_vertices_by_links(links: Links, matrix: FormFactors) -> None:
    mesh, B = mesh_of(links.patches), solved(matrix)[-1].B
    by_links, by_matrix = gathered(links, mesh, B), gathered(matrix, mesh, B)
    lit = links.patches.E[mesh.patch].max(axis=1) == 0.0
    error = by_links[lit] - by_matrix[lit]
    assert np.sqrt((error**2).mean() / (by_matrix[lit] ** 2).mean()) < 0.006


def test_threads_do_not_change_links(tree: Tree, links: Links) -> None:
    again = linked(tree, rays=Rays(tree.nodes.scene, 1))
    assert np.array_equal(again.ends, links.ends)
    assert np.array_equal(again.S, links.S)


def test_links_have_no_matrix(links: Links) -> None:
    with pytest.raises(SceneError, match="there is no matrix for this solver: choose cg or jacobi"):
        solved(links, "lu")


def test_links_that_would_not_fit(tree: Tree) -> None:
    with pytest.raises(SceneError, match="GiB of links, and not all are found: take fewer patches"):
        linked(tree, 1e-6, limit=10**6)


def test_hierarchical_from_end_to_end() -> None:
    result = radiosity.solve("furnace", 3000, method="hierarchical")
    assert result.vertex_radiosity == pytest.approx(2.0, rel=2e-3)
    assert np.average(result.B[:, 0], weights=result.patches.area) == pytest.approx(2.0, rel=5e-4)
    report = result.report()
    assert report["method"] == "hierarchical"
    assert report["solver"] == "cg"
    assert report["reciprocity"] == 0.0
    assert report["row_sum_error_mean"] < 0.004
    with pytest.raises(SceneError, match="no matrix that could be shown"):
        result.matrix_picture()


def test_a_tree_has_about_as_many_elements_as_asked() -> None:
    assert len(tree_of(hall().checked(), 20000).leaves) == pytest.approx(20000, rel=0.35)


@pytest.mark.slow
def test_what_is_hidden_in_part_stays() -> None:
    """The top of a crate, in the middle of which a cone stands, whatever the size of patches."""
    room = hall().checked()
    tree = tree_of(room, 5000)
    for found in (tree.nodes, subdivide(room, 400), subdivide(room, 1500)):
        roots = found.level == 0
        top = roots & (np.abs(found.center[:, 1] - 1.5) < 1e-6) & (found.normal[:, 1] > 0.9)
        here = top & (found.center[:, 0] < 5.0)
        assert found.area[here].sum() == pytest.approx(2.0 * 2.2, rel=1e-6)


# ---------------------------------------------------------------- smaller patches where it matters


def balanced(patches: Patches) -> bool:
    lines = outline(patches)
    finest = np.zeros(len(lines.positions), int)
    np.maximum.at(finest, lines.corners.ravel(), np.repeat(patches.level, 4))
    return all(finest[there].max() <= patches.level[patch] + 1 for (patch, _), there in lines.between.items())


def test_divided_patches_are_balanced_and_have_no_t_vertices() -> None:
    patches = subdivide(scene("cornell"), 300)
    random = np.random.default_rng(3)
    for _ in range(3):
        patches = divided(patches, random.uniform(size=len(patches)) < 0.04)
    assert patches.level.max() == 3
    assert balanced(patches)
    whole = subdivide(scene("cornell"), 300)
    assert patches.area.sum() == pytest.approx(whole.area.sum(), rel=1e-12)
    mesh = mesh_of(patches)
    for polygon in (0, 1):
        chosen = mesh.triangles[patches.polygon[mesh.triangle_patch] == polygon]
        points = mesh.vertices[np.unique(chosen)]
        for triangle in mesh.vertices[chosen]:
            for a, b in pairwise([*triangle, triangle[0]]):
                along = (points - a) @ (b - a) / ((b - a) @ (b - a))
                away = np.linalg.norm(points - a - along[:, None] * (b - a), axis=1)
                assert not ((along > 1e-3) & (along < 1 - 1e-3) & (away < 1e-3)).any()


def cross(one: np.ndarray, two: np.ndarray) -> np.ndarray:
    return one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]


def shown_on_the_floor(factors: Factors, points: np.ndarray) -> np.ndarray:
    """Radiosity at points of the floor as it is drawn: interpolated over triangles."""
    mesh = mesh_of(factors.patches)
    shown = gathered(factors, mesh, solved(factors)[-1].B)
    chosen = mesh.triangles[factors.patches.polygon[mesh.triangle_patch] == 0]
    a, b, c = (mesh.vertices[chosen[:, k]][:, [0, 2]] for k in range(3))
    result = np.full((len(points), 3), np.nan)
    for number, p in enumerate(points[:, [0, 2]]):
        weights = np.stack([cross(b - p, c - p), cross(c - p, a - p), cross(a - p, b - p)], axis=1)
        weights /= cross(b - a, c - a)[:, None]
        inside = int(np.argmax(weights.min(axis=1)))
        result[number] = weights[inside] @ shown[chosen[inside]]
    return result


@pytest.mark.slow
def test_adaptive_patches_show_more_with_as_many() -> None:
    """On the floor, where the shadows are, against a final gather from many patches."""
    room = scene("cornell")
    random = np.random.default_rng(4)
    points = np.stack([random.uniform(5, 545, 400), np.zeros(400), random.uniform(5, 554, 400)], axis=1)
    fine = compute(subdivide(room, 2000))
    B = solved(fine)[-1].B
    adaptive = compute(refined(subdivide(room, 250), 1000, compute))
    uniform = compute(subdivide(room, len(adaptive.patches)))
    floor = np.flatnonzero(fine.patches.polygon == 0)
    nearest = floor[np.argmin(np.linalg.norm(fine.patches.center[floor, None] - points, axis=2), axis=0)]
    true = radiosity_at(fine, points, np.tile([0.0, 1.0, 0.0], (400, 1)), nearest, B)
    seen = true.max(axis=1) > 0.0  # not below the blocks
    wrong = [np.sqrt(((shown_on_the_floor(found, points) - true)[seen] ** 2).mean()) for found in (adaptive, uniform)]
    assert wrong[0] < 0.8 * wrong[1]
