"""Prints the polynomials of `src/scalar/precision` with their errors: minimax approximations by
the exchange algorithm of Remez, in sixty digits. Needs mpmath; run as `python3 coefficients.py`.

For each polynomial: name, precision, and the largest error after rounding its coefficients, with
the weight that makes it an error of the function that is made of it. Where arguments are large, so
are the errors of rounded coefficients; there these are moved by single units in the last place as
long as that makes the largest error smaller.
"""

import math
import struct

from mpmath import acos, acosh, atan, cos, cosh, exp, factorial, log, lu_solve, matrix, mp, mpf, pi, sin, sinh, sqrt

mp.dps = 60
SMALL = mpf(10) ** -8


def double(x):
    return mpf(float(x))


def single(x):
    return mpf(struct.unpack("f", struct.pack("f", float(x)))[0])


def near_zero(series, function):
    """The function, by its power series where it would cancel."""
    return lambda x: sum(c * x**n for n, c in enumerate(series)) if abs(x) < SMALL else function(x)


def cosh_root(a):
    return cos(sqrt(-a)) if a < 0 else cosh(sqrt(a))


def sinhc_root(a):
    return sin(sqrt(-a)) / sqrt(-a) if a < 0 else sinh(sqrt(a)) / sqrt(a)


ARC_SERIES = [mpf(1)]
for k in range(12):
    ARC_SERIES.append(ARC_SERIES[-1] * (k + 1) / (2 * k + 3))


def arc(x):
    c = 1 - x
    return acos(c) / sqrt(1 - c * c) if x > 0 else acosh(c) / sqrt(c * c - 1)


def of_root(function):
    return lambda z: function(sqrt(z))


TERMS = range(12)
SINHC = near_zero([1 / factorial(2 * n + 3) for n in TERMS], lambda a: (sinhc_root(a) - 1) / a)
SINHC_SLOPE = near_zero(
    [(n + 1) / factorial(2 * n + 3) for n in TERMS],
    lambda a: (cosh_root(a) - sinhc_root(a)) / (2 * a),
)
ARC = near_zero(ARC_SERIES[1:], lambda x: (arc(x) - 1) / x)
EXPONENTIAL = near_zero([1 / factorial(n + 2) for n in TERMS], lambda r: (exp(r) - 1 - r) / r**2)
LOGARITHM = near_zero(
    [mpf(2) / (2 * n + 3) for n in TERMS],
    of_root(lambda t: (log((1 + t) / (1 - t)) - 2 * t) / t**3),
)
SINE = near_zero(
    [(-1) ** (n + 1) / factorial(2 * n + 3) for n in TERMS], of_root(lambda t: (sin(t) - t) / t**3)
)
COSINE = near_zero(
    [(-1) ** n / factorial(2 * n + 4) for n in TERMS],
    of_root(lambda t: (cos(t) - 1 + t * t / 2) / t**4),
)
ARCTANGENT = near_zero(
    [mpf(-1) ** (n + 1) / (2 * n + 3) for n in TERMS], of_root(lambda t: (atan(t) - t) / t**3)
)


def minimax(function, weight, low, high, count):
    """The polynomial of `count` coefficients whose weighted error alternates."""
    points = 400
    reference = [(low + high) / 2 - (high - low) / 2 * cos(pi * k / count) for k in range(count + 1)]
    for _ in range(6):
        rows, values = matrix(count + 1, count + 1), matrix(count + 1, 1)
        for i, x in enumerate(reference):
            for j in range(count):
                rows[i, j] = x**j
            rows[i, count] = (-1) ** i / weight(x)
            values[i] = function(x)
        coefficients = list(lu_solve(rows, values))[:count]
        xs = [(low + high) / 2 - (high - low) / 2 * cos(pi * k / points) for k in range(points + 1)]
        errors = [weight(x) * (evaluate(coefficients, x) - function(x)) for x in xs]
        extrema, best = [], 0
        for k in range(1, points + 1):
            if errors[k] * errors[best] < 0:
                extrema.append(best)
                best = k
            elif abs(errors[k]) > abs(errors[best]):
                best = k
        extrema.append(best)
        while len(extrema) > count + 1:
            extrema.pop(0 if abs(errors[extrema[0]]) < abs(errors[extrema[-1]]) else -1)
        if len(extrema) < count + 1:
            break
        reference = [xs[k] for k in extrema]
    return coefficients


def evaluate(coefficients, x):
    return sum(c * x**n for n, c in enumerate(coefficients))


def settled(coefficients, digits, function, weight, xs):
    """The coefficients after moves of one or two of them by a unit in the last place, each of which
    makes the largest error smaller."""
    units = [mpf(2) ** (math.frexp(float(c))[1] - digits) for c in coefficients]
    errors = [float(weight(x) * (evaluate(coefficients, x) - function(x))) for x in xs]
    steps = [[float(weight(x) * u * x**n) for x in xs] for n, u in enumerate(units)]
    single_moves = [((n, sign),) for n in range(len(units)) for sign in (-1, 1)]
    pairs = [(a, b) for (a,) in single_moves for (b,) in single_moves if a[0] > b[0]]
    improved = True
    while improved:
        improved = False
        for move in single_moves + pairs:
            moved = errors
            for n, sign in move:
                moved = [e + sign * step for e, step in zip(moved, steps[n])]
            if max(map(abs, moved)) < 0.999 * max(map(abs, errors)):
                errors, improved = moved, True
                for n, sign in move:
                    coefficients[n] += sign * units[n]
    return coefficients


def show(name, function, weight, low, high, counts, settle=False):
    low, high = mpf(low), mpf(high)
    for kind, rounded, digits, count in (("f64", double, 53, counts[0]), ("f32", single, 24, counts[1])):
        coefficients = [rounded(c) for c in minimax(function, weight, low, high, count)]
        xs = [low + (high - low) * k / 300 for k in range(301)]
        if settle:
            coefficients = settled(coefficients, digits, function, weight, xs)
        error = max(abs(weight(x) * (evaluate(coefficients, x) - function(x))) for x in xs)
        print(f"{name} {kind}: error {mp.nstr(error, 1)}")
        for c in coefficients:
            print("   ", repr(float(c)) if kind == "f64" else "%.9g" % float(c))


def size(x):
    return abs(x) + mpf(10) ** -6


START, END = -(pi**2) - mpf("0.01"), 1
show("SINHC", SINHC, size, START, END, (10, 6), settle=True)
show("SINHC_SLOPE", SINHC_SLOPE, lambda a: 2 * size(a), START, END, (11, 6), settle=True)
show("ARC", ARC, lambda x: size(x) / (1 + x * ARC(x)), mpf(-1) / 8, 1, (22, 9))
END = log(2) / 2 + mpf("0.001")
show("EXPONENTIAL", EXPONENTIAL, lambda r: r * r + SMALL, -END, END, (11, 5))
END = ((sqrt(2) - 1) / (sqrt(2) + 1)) ** 2 * mpf("1.01")
show("LOGARITHM", LOGARITHM, lambda z: z + SMALL, 0, END, (7, 3))
END = (pi / 4) ** 2 * mpf("1.001")
show("SINE", SINE, size, 0, END, (6, 3))
show("COSINE", COSINE, lambda z: z * z + mpf(10) ** -6, 0, END, (6, 3))
END = (sqrt(2) - 1) ** 2 * mpf("1.001")
show("ARCTANGENT", ARCTANGENT, size, 0, END, (11, 5))
