"""What an error costs, from measured (error, seconds) pairs."""
import math


def pareto(points):
    """the pairs that no other beats in both, by rising error"""
    best = []
    for error, cost in sorted(points):
        if error > 0 and (not best or cost < best[-1][1]):
            best.append((error, cost))
    return best


def between(a, b, error):
    """on the line through two pairs in logarithms"""
    slope = math.log(b[1] / a[1]) / math.log(b[0] / a[0])
    return a[1] * (error / a[0]) ** slope


def cost_at(points, error, extrapolate=False):
    """-> (seconds for `error` on the front, mark): '' interpolated, '<' the cheapest pair is better than that,
    '*' extrapolated over the last two pairs, which are the dearest; (None, '') where nothing reaches it"""
    front = pareto(points)
    if not front:
        return None, ""
    if error >= front[-1][0]:
        return front[-1][1], "<"
    for a, b in zip(front, front[1:]):
        if a[0] <= error <= b[0]:
            return between(a, b, error), ""
    if extrapolate and len(front) > 1:
        return between(front[0], front[1], error), "*"
    return None, ""


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values)) if values else None
