"""Writes kingdon.tsv and galgebra.tsv: products of basis blades by two independent programs.

    python3 -m venv venv && venv/bin/pip install kingdon==3.0.0 galgebra==0.6.0
    venv/bin/python generate.py

A line `metric` gives the rows of a Gram matrix, separated by `;`. The lines after it hold a
product, the mask of the left blade, the mask of the right blade and the terms
`mask:coefficient`, separated by spaces (none if the product is zero). Basis blades are outer
products of basis vectors in increasing order.
"""

from importlib.metadata import version
from pathlib import Path

from galgebra.ga import Ga
from kingdon import Algebra
from sympy import Matrix, Rational, sympify

HERE = Path(__file__).parent


def metric(gram):
    return "metric\t" + ";".join(",".join(str(entry) for entry in line) for line in gram) + "\n"


def row(product, a, b, terms):
    terms = " ".join(f"{mask}:{value}" for mask, value in sorted(terms.items()) if value != 0)
    return f"{product}\t{a}\t{b}\t{terms}\n"


def header(program):
    return f"# {program} {version(program)}, written by generate.py\n"


def kingdon():
    """Orthonormal metrics, among them a degenerate one. Its inner product keeps scalars, which
    (2.71) does not: pairs with a scalar are left out there."""
    methods = {
        "geometric": "gp",
        "wedge": "op",
        "left_contract": "lc",
        "right_contract": "rc",
        "inner": "ip",
        "scalar_product": "sp",
        "commutator": "cp",
        "anticommutator": "acp",
    }
    for signature in ([0, 1, 1, 1], [1, -1, -1], [1, 0, -1]):
        algebra = Algebra(signature=signature)
        size = len(signature)
        gram = [[s if i == j else 0 for j in range(size)] for i, s in enumerate(signature)]
        yield metric(gram)
        blades = range(1 << size)
        for product, method in methods.items():
            for a in blades:
                for b in blades:
                    if product == "inner" and 0 in (a, b):
                        continue
                    left = algebra.multivector(keys=(a,), values=[1])
                    right = algebra.multivector(keys=(b,), values=[1])
                    result = getattr(left, method)(right)
                    yield row(product, a, b, dict(result.items()))


def galgebra():
    """Metrics with basis vectors that are not orthogonal; the second is the null basis of the
    conformal model of the plane."""
    half = Rational(1, 2)
    products = {
        "geometric": lambda a, b: a * b,
        "wedge": lambda a, b: a ^ b,
        "left_contract": lambda a, b: a < b,
        "right_contract": lambda a, b: a > b,
        "inner": lambda a, b: a | b,
    }
    grams = (
        [[2, 1, 0], [1, -1, half], [0, half, 3]],
        [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, -1], [0, 0, -1, 0]],
    )
    for gram in grams:
        size = len(gram)
        algebra = Ga(" ".join(f"e_{i}" for i in range(1, size + 1)), g=Matrix(gram))
        vectors = algebra.mv()
        blades = []
        for mask in range(1 << size):
            blade = algebra.mv(1)
            for index in range(size):
                if mask >> index & 1:
                    blade = blade ^ vectors[index]
            blades.append(blade)
        yield metric(gram)
        for product, operation in products.items():
            for a, left in enumerate(blades):
                for b, right in enumerate(blades):
                    # Its products of two scalars are plain numbers.
                    result = algebra.mv(operation(left, right))
                    values = (sympify(str(value)) for value in result.blade_coefs(blades))
                    terms = dict(enumerate(values))
                    yield row(product, a, b, terms)


for program in (kingdon, galgebra):
    lines = [header(program.__name__), *program()]
    (HERE / f"{program.__name__}.tsv").write_text("".join(lines))
