RIGHT = {
    "two sums": """
def sweep(F, rho, E, B):
    n, new = len(E), []
    for i in range(n):
        row = []
        for c in range(3):
            visited = sum(F[i][j] * new[j][c] for j in range(i))
            others = sum(F[i][j] * B[j][c] for j in range(i + 1, n))
            row.append(E[i][c] + rho[i][c] * (visited + others))
        new.append(row)
    return new


def gauss_seidel(F, rho, E, sweeps):
    result = [E.tolist()]
    for k in range(sweeps):
        result.append(sweep(F, rho, E, result[k]))
    return result


def backwards(F, rho, E, B):
    return sweep(F[::-1, ::-1], rho[::-1], E[::-1], B[::-1])[::-1]
""",
    "with a triangular system": """
import numpy as np


def sweep(F, rho, E, B):
    new = np.empty_like(E)
    for c in range(3):
        RF = np.diag(rho[:, c]) @ F
        new[:, c] = np.linalg.solve(np.eye(len(F)) - np.tril(RF), E[:, c] + np.triu(RF) @ B[:, c])
    return new


def backwards(F, rho, E, B):
    new = np.empty_like(E)
    for c in range(3):
        RF = np.diag(rho[:, c]) @ F
        new[:, c] = np.linalg.solve(np.eye(len(F)) - np.triu(RF), E[:, c] + np.tril(RF) @ B[:, c])
    return new


def gauss_seidel(F, rho, E, sweeps):
    B = np.zeros((sweeps + 1, *E.shape))
    B[0] = E
    for k in range(sweeps):
        B[k + 1] = sweep(F, rho, E, B[k])
    return B
""",
}

VISIT = "E[i] + rho[i] * (F[i] @ B)"
COPY = "    B = B.copy()\n"
NEXT = "steps.append(sweep(F, rho, E, steps[-1]))"
FORWARDS = "visit(F, rho, E, B, range(len(B)))"
BACK = "visit(F, rho, E, B, range(len(B) - 1, -1, -1))"
WRONG = {
    "nothing gathered": ([(VISIT, "B[i]")], "gather no light"),
    "Jacobi": ([(VISIT, "E[i] + rho[i] * (F[i] @ old)"), (COPY, "    old, B = B, B.copy()\n")], "Jacobi's order"),
    "backwards": ([(FORWARDS, "visit(F, rho, E, B, range(len(B))[::-1])")], "begin with patch 0"),
    "there and back": ([("for i in order:", "for i in [*range(len(B)), *range(len(B))[::-1]]:")], "forwards and back"),
    "two sweeps": ([(FORWARDS, "visit(F, rho, E, B, 2 * list(range(len(B))))")], "two sweeps"),
    "old values missing": ([("F[i] @ B", "F[i, :i] @ B[:i]")], "old values belong"),
    "new values missing": ([("F[i] @ B", "F[i, i:] @ B[i:]")], "new values belong"),
    "no emission": ([(VISIT, "rho[i] * (F[i] @ B)")], "E is missing"),
    "no reflectance": ([(VISIT, "E[i] + F[i] @ B")], "reflectances are missing"),
    "transposed": ([("F[i] @ B", "F[:, i] @ B")], "transposed"),
    "rho times E": ([(VISIT, "rho[i] * (E[i] + F[i] @ B)")], "emitted, not reflected"),
    "from E": ([("B = B.copy()", "B = E.copy()")], "begins with E"),
    "old B kept": ([(VISIT, "B[i] + rho[i] * (F[i] @ B)")], "old B_i stays"),
    "mean of the channels": ([("rho[i] *", "rho[i].mean() *")], "own reflectance"),
    "from the dark": ([("steps = [E]", "steps = [0 * E]")], "in the dark"),
    "B changed in place": ([(COPY, "")], "E itself was changed"),
    "one array for all": (
        [("steps = [E]", "B = 1 * E\n    steps = [B]"), (NEXT, "B[:] = sweep(F, rho, E, B)\n        steps.append(B)")],
        "All sweeps are equal to the last",
    ),
    "from E each time": ([(NEXT, "steps.append(sweep(F, rho, E, E))")], "not with E"),
    "without sweep 0": ([("np.array(steps)", "np.array(steps[1:])")], "expected: a 2 x 3 x 3 array"),
    "one sweep late": ([("steps = [E]", "steps = [sweep(F, rho, E, E)]")], "after the first sweep"),
    "only the last": ([("np.array(steps)", "steps[-1]")], "expected: a 2 x 3 x 3 array"),
    "not backwards": ([(BACK, "sweep(F, rho, E, B)")], "as in sweep"),
    "result reversed": ([(BACK, "sweep(F, rho, E, B)[::-1]")], "reverses the result"),
    "patch 0 left out": ([(BACK, BACK.replace("-1, -1))", "0, -1))"))], "Patch 0"),
    "last patch left out": ([(BACK, BACK.replace("len(B) - 1", "len(B) - 2"))], "last patch"),
}
