RIGHT = {
    "by bounces": """
import numpy as np

DIRECT = [1.0, 0.5]
FULL = sum(np.array([0.25**k, 0.5 * 0.25**k]) for k in range(40))
SHARE = DIRECT[1] / FULL[1]


def direct(F, rho, E):
    return E + np.stack([np.diag(rho[:, c]) @ F @ E[:, c] for c in range(3)], axis=1)


def indirect(F, rho, E):
    bounce, total = rho * (F @ E), 0
    for _ in range(2000):
        bounce = rho * (F @ bounce)
        total = total + bounce
    return total


def glow(F, A, rho, E):
    return (A[:, None] * indirect(F, rho, E)).sum(axis=0) / (A[:, None] * rho).sum(axis=0)
""",
    "with loops": """
import numpy as np

a = np.linalg.solve([[1, -0.5], [-0.5, 1]], [1, 0])
DIRECT, FULL, SHARE = np.array([1, 0.5]), a, 0.5 / a[1]


def gather(F, rho, B):
    n = len(B)
    return [[rho[i][c] * sum(F[i][j] * B[j][c] for j in range(n)) for c in range(3)] for i in range(n)]


def direct(F, rho, E):
    return [[e + g for e, g in zip(a, b)] for a, b in zip(E, gather(F, rho, E))]


def indirect(F, rho, E):
    columns = []
    for c in range(3):
        RF = np.diag(rho[:, c]) @ F
        columns.append(np.linalg.inv(np.eye(len(F)) - RF) @ RF @ RF @ E[:, c])
    return np.array(columns).T


def glow(F, A, rho, E):
    return np.average(indirect(F, rho, E) / rho, axis=0, weights=A[:, None] * rho)
""",
}

ONE = "E + rho * (F @ E)"
REST = "full(F, rho, E) - direct(F, rho, E)"
POWER, GLOW = "A @ indirect(F, rho, E)", "power / (A @ rho)"
WRONG = {
    "no reflectance": ([("DIRECT = (1, 1 / 2)", "DIRECT = (1, 1)")], "only half"),
    "lamp alone": ([("DIRECT = (1, 1 / 2)", "DIRECT = (1, 0)")], "emitted light alone"),
    "two bounces": ([("FULL = (4 / 3, 2 / 3)", "FULL = (1.25, 0.5)")], "after two bounces"),
    "half left": ([("FULL = (4 / 3, 2 / 3)", "FULL = (2, 1)")], "a quarter is left"),
    "integer division": ([("FULL = (4 / 3, 2 / 3)", "FULL = (4 // 3, 2 // 3)")], "Follow the light"),
    "the other share": ([("SHARE = 3 / 4", "SHARE = 0.25")], "leaves out"),
    "percent": ([("SHARE = 3 / 4", "SHARE = 75")], "percent"),
    "no emission": ([(ONE, "rho * (F @ E)")], "emitted light E is missing"),
    "arriving light": ([(ONE, "E + F @ E")], "arriving light"),
    "rho first": ([(ONE, "E + F @ (rho * E)")], "rho comes after F"),
    "transposed": ([(ONE, "E + rho * (F.T @ E)")], "transposed"),
    "all reflected": ([(ONE, "rho * (E + F @ E)")], "emitted, not reflected"),
    "all bounces": ([(ONE, "full(F, rho, E)")], "These are all bounces; direct"),
    "nothing taken away": ([(REST, "full(F, rho, E)")], "take away what direct"),
    "first bounce left": ([(REST, "full(F, rho, E) - E")], "first bounce is in it"),
    "sign": ([(REST, "direct(F, rho, E) - full(F, rho, E)")], "sign is wrong"),
    "second bounce": ([(REST, "rho * (F @ (rho * (F @ E)))")], "second bounce only"),
    "red for all": ([("rho[:, c, None]", "rho[:, 0, None]")], "red ones"),
    "plain mean": ([(GLOW, "indirect(F, rho, E).mean(axis=0)")], "plain mean of the indirect"),
    "mean radiosity": ([(GLOW, "power / A.sum()")], "mean radiosity"),
    "power": ([(GLOW, "power")], "power itself"),
    "no areas": ([(GLOW, "indirect(F, rho, E).sum(axis=0) / rho.sum(axis=0)")], "areas are missing"),
    "direct light in it": ([(POWER, "A @ full(F, rho, E)")], "direct light is in it"),
    "mean of the arriving": ([(GLOW, "A @ (indirect(F, rho, E) / rho) / A.sum()")], "weigh with A rho"),
}  # fmt: skip
