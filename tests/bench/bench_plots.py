"""Growth plots of the bench as SVG: logarithmic axes, one line per series, labelled with the slope of its last two points."""
import math
import pathlib

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 700, 360, 70, 290, 30, 50
COLOURS = ("#1f6fb4", "#d1662a", "#3b8f4e", "#7a4fa3", "#8c6d31")


def decades(values):
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    return low, max(high, low + 1)


def loglog(title, x_name, y_name, series):
    """@param series  name -> [(x, y), ...], positive"""
    series = {name: sorted(points) for name, points in series.items() if points}
    x_low, x_high = decades([x for points in series.values() for x, _ in points])
    y_low, y_high = decades([y for points in series.values() for _, y in points])
    right, bottom = WIDTH - RIGHT, HEIGHT - BOTTOM

    def place(x, y):
        return (LEFT + (math.log10(x) - x_low) / (x_high - x_low) * (right - LEFT),
                bottom - (math.log10(y) - y_low) / (y_high - y_low) * (bottom - TOP))
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="12">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
           f'<text x="{(LEFT + right) / 2}" y="18" text-anchor="middle" font-size="13">{title}</text>']
    for k in range(x_low, x_high + 1):
        x, _ = place(10.0 ** k, 10.0 ** y_low)
        out.append(f'<path d="M{x:.1f} {TOP}V{bottom}" stroke="#ddd"/><text x="{x:.1f}" y="{bottom + 16}" text-anchor="middle">1e{k}</text>')
    for k in range(y_low, y_high + 1):
        _, y = place(10.0 ** x_low, 10.0 ** k)
        out.append(f'<path d="M{LEFT} {y:.1f}H{right}" stroke="#ddd"/><text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">1e{k}</text>')
    out.append(f'<text x="{(LEFT + right) / 2}" y="{HEIGHT - 10}" text-anchor="middle">{x_name}</text>')
    out.append(f'<text transform="translate(16 {(TOP + bottom) / 2}) rotate(-90)" text-anchor="middle">{y_name}</text>')
    for (name, points), colour in zip(series.items(), COLOURS):
        at = [place(x, y) for x, y in points]
        out.append(f'<polyline fill="none" stroke="{colour}" stroke-width="1.5" points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in at) + '"/>')
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in at]
        slope = ""
        if len(points) > 1:
            (x0, y0), (x1, y1) = points[-2:]
            slope = f" (N^{math.log(y1 / y0) / math.log(x1 / x0):.2f})"
        out.append(f'<text x="{right + 8}" y="{at[-1][1] + 4:.1f}" fill="{colour}">{name}{slope}</text>')
    return "\n".join([*out, "</svg>", ""])


def write(folder, growth):
    """@param growth  file name -> (title, name of y, series over N)"""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name, (title, y_name, series) in growth.items():
        if any(len(points) > 1 for points in series.values()):
            (folder / f"{name}.svg").write_text(loglog(title, "N", y_name, series))
