RIGHT = {
    "with loops": """
def sweep(F, rho, E, B):
    n = len(E)
    new = []
    for i in range(n):
        new.append([E[i][c] + rho[i][c] * sum(F[i][j] * B[j][c] for j in range(n) if j != i) for c in range(3)])
    return new


def jacobi(F, rho, E, sweeps):
    result = [E.tolist()]
    while len(result) <= sweeps:
        result.append(sweep(F, rho, E, result[-1]))
    return result


def sweeps_needed(F, rho, E, small):
    k, old, new = 1, E, sweep(F, rho, E, E)
    while not all(abs(x - y) <= small for p, q in zip(old, new) for x, y in zip(p, q)):
        k, old, new = k + 1, new, sweep(F, rho, E, new)
    return k
""",
    "with powers of the matrix": """
import numpy as np


def sweep(F, rho, E, B):
    out = E.copy()
    for c in range(3):
        out[:, c] += np.diag(rho[:, c]) @ F @ B[:, c]
    return out


def jacobi(F, rho, E, sweeps):
    B = np.zeros((sweeps + 1,) + E.shape)
    for c in range(3):
        RF, bounce = rho[:, c, None] * F, E[:, c]
        for k in range(sweeps + 1):
            B[k:, :, c] += bounce
            bounce = RF @ bounce
    return B


def sweeps_needed(F, rho, E, small):
    B = jacobi(F, rho, E, 1000)
    changes = np.abs(np.diff(B, axis=0)).max(axis=(1, 2))
    return np.array([np.argmax(changes <= small) + 1])
""",
}

STEP = "E + rho * (F @ B)"
NEXT = "steps.append(sweep(F, rho, E, steps[-1]))"
WRONG = {
    "nothing gathered": ([(STEP, "B")], "gather no light"),
    "Gauss-Seidel": (
        [
            (
                "    return " + STEP,
                "    B = 1 * B\n    for i in range(len(B)):\n        B[i] = E[i] + rho[i] * (F[i] @ B)\n    return B",
            )
        ],
        "Gauss-Seidel's order",
    ),
    "no emission": ([(STEP, "rho * (F @ B)")], "E is missing"),
    "no reflectance": ([(STEP, "E + F @ B")], "reflectances are missing"),
    "transposed": ([(STEP, "E + rho * (F.T @ B)")], "transposed"),
    "rho of the sender": ([(STEP, "E + F @ (rho * B)")], "rho belongs to i"),
    "rho times E": ([(STEP, "rho * (E + F @ B)")], "emitted, not reflected"),
    "old B kept": ([(STEP, "B + rho * (F @ B)")], "old B_i stays"),
    "E gathered": ([(STEP, "E + rho * (F @ E)")], "gathers E, not B"),
    "sign": ([(STEP, "E - rho * (F @ B)")], "not taken away"),
    "mean of the channels": ([(STEP, "E + rho.mean(axis=1, keepdims=True) * (F @ B)")], "own reflectance"),
    "from the dark": ([("steps = [E]", "steps = [0 * E]")], "in the dark"),
    "the same array": (
        [
            ("steps = [E]", "B = E.copy()\n    steps = [B]"),
            (NEXT, "B[:] = sweep(F, rho, E, B)\n        steps.append(B)"),
        ],
        "Keep a copy",
    ),
    "from E each time": ([(NEXT, "steps.append(sweep(F, rho, E, E))")], "not from E"),
    "without step 0": ([("np.array(steps)", "np.array(steps[1:])")], "expected: a 2 x 2 x 3 array"),
    "one step late": ([("steps = [E]", "steps = [sweep(F, rho, E, E)]")], "begins with step 1"),
    "one too few": ([("return k", "return k - 1")], "one too small"),
    "one too many": ([("return k", "return k + 1")], "one too large"),
    "mean change": ([("np.max(", "np.mean(")], "mean change"),
    "red only": ([("np.abs(new - B)", "np.abs(new - B)[:, 0]")], "red channel"),
    "no absolute value": ([("np.abs(new - B)", "B - new")], "in all patches and channels"),
}
