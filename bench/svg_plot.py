"""Plots as SVG text: bars, and lines over logarithmic axes. Standard library only."""
import html
import math

WIDTH, COLOURS = 640, ["#1f6feb", "#d1242f", "#1a7f37", "#9a6700", "#8250df", "#57606a"]


def _document(height, title, body):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" font-size="12">\n'
            f'<rect width="{WIDTH}" height="{height}" fill="white"/>\n<text x="16" y="22" font-size="15">{html.escape(title)}</text>\n'
            + "\n".join(body) + "\n</svg>\n")


def _text(x, y, words, anchor="start"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{html.escape(words)}</text>'


def _line(x0, y0, x1, y1, colour="#d0d7de", width=1):
    return f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}" stroke="{colour}" stroke-width="{width}"/>'


def bars(title, unit, rows):
    """rows: (label, value, group); bars of one group share a colour."""
    left, step, top = 230, 24, 40
    largest = max(value for _, value, _ in rows)
    groups = list(dict.fromkeys(group for _, _, group in rows))
    body = []
    for i, (label, value, group) in enumerate(rows):
        y, length = top + i * step, (WIDTH - left - 110) * value / largest
        body.append(_text(left - 8, y + 14, label, "end"))
        body.append(f'<rect x="{left}" y="{y + 2}" width="{length:.1f}" height="{step - 8}" fill="{COLOURS[groups.index(group)]}"/>')
        body.append(_text(left + length + 6, y + 14, f"{value:.3g} {unit}" if value < 1000 else f"{value:.0f} {unit}"))
    return _document(top + step * len(rows) + 12, title, body)


def log_lines(title, x_label, y_label, curves):
    """curves: name to [(x, y)], all positive; both axes in powers of 2 and 10."""
    left, right, top, bottom = 70, WIDTH - 130, 52, 380
    xs = [x for points in curves.values() for x, _ in points]
    ys = [y for points in curves.values() for _, y in points]
    x0, x1 = math.log2(min(xs)), math.log2(max(xs))
    y0, y1 = math.floor(math.log10(min(ys))), math.ceil(math.log10(max(ys)))

    def place(x, y):
        return (left + (right - left) * (math.log2(x) - x0) / (x1 - x0),
                bottom - (bottom - top) * (math.log10(y) - y0) / (y1 - y0))

    body = []
    for power in range(math.ceil(x0), math.floor(x1) + 1):
        x, _ = place(2 ** power, 10 ** y0)
        body += [_line(x, top, x, bottom), _text(x, bottom + 16, str(2 ** power), "middle")]
    for power in range(y0, y1 + 1):
        _, y = place(2 ** x0, 10 ** power)
        body += [_line(left, y, right, y), _text(left - 6, y + 4, f"1e{power}", "end")]
    body += [_text((left + right) / 2, bottom + 36, x_label, "middle"), _text(16, 36, y_label)]
    for colour, (name, points) in zip(COLOURS, curves.items()):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in (place(*p) for p in points))
        body.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
    # Names beside the last points, pushed apart where curves end together.
    below = -math.inf
    for end, name, colour in sorted((place(*points[-1])[1], name, colour) for colour, (name, points) in zip(COLOURS, curves.items())):
        below = max(end + 4, below + 14)
        body.append(f'<text x="{right + 8}" y="{below:.1f}" fill="{colour}">{html.escape(name)}</text>')
    return _document(bottom + 48, title, body)
