RIGHT = {
    "element by element": """
import numpy as np


def system(F, rho):
    n = len(F)
    return [[(1 if i == j else 0) - rho[i] * F[i][j] for j in range(n)] for i in range(n)]


def solve(F, rho, E):
    channels = [np.linalg.inv(np.array(system(F, rho[:, c]))) @ E[:, c] for c in range(3)]
    return np.array(channels).T
""",
    "by bounces": """
import numpy as np


def system(F, rho):
    return np.identity(F.shape[0]) - F * rho.reshape(-1, 1)


def solve(F, rho, E):
    B = E
    for _ in range(2000):
        B = E + rho * (F @ B)
    return B
""",
}

WRONG = {
    "columns": ([("R @ F", "F @ R")], "belongs to row i"),
    "sign": ([("np.eye(len(F)) - R @ F", "np.eye(len(F)) + R @ F")], "sign is wrong"),
    "no reflectances": ([("R @ F", "F")], "reflectances are missing"),
    "no identity": ([("np.eye(len(F)) - R @ F", "R @ F")], "B_i itself"),
    "transposed": ([("R @ F", "R @ F.T")], "transposed"),
    "ones everywhere": ([("np.eye(len(F))", "1")], "diagonal only"),
    "negative": ([("np.eye(len(F)) - R @ F", "R @ F - np.eye(len(F))")], "negative of the matrix"),
    "red for all": ([("rho[:, channel]", "rho[:, 0]")], "its own matrix"),
    "multiplied": (
        [("np.linalg.solve(system(F, rho[:, channel]), E[:, channel])", "system(F, rho[:, channel]) @ E[:, channel]")],
        "solved for B",
    ),
    "one bounce": ([("    return B", "    return E + rho * (F @ E)")], "one bounce"),
    "two channels": ([("range(3)", "range(2)")], "for each channel"),
}
