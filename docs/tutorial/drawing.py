"""Draws section.dxf, the section of the tutorial, as a CAD program would: python3-ezdxf, R2010, metres.   usage: drawing.py [FILE]"""

import sys

import ezdxf

OUTLINE = [(-40, -20), (110, -20), (110, 60), (28, 60), (0, 0), (-40, 0)]
BASE = [(-40, -20), (110, -20), (110, 60), (82.6, 60), (2.75, 2), (1, 0), (-40, 0)]
WATER = [(-40, -1.5), (0, -0.5), (20, 17), (50, 43), (82, 56), (110, 57)]
ANCHORS = [((7.0, 15), (25.97, 9.92)), ((10.5, 22.5), (34.45, 16.08)), ((14.0, 30), (42.94, 22.24)), ((17.5, 37.5), (51.42, 28.41)), ((21.0, 45), (59.91, 34.57)), ((24.5, 52.5), (68.39, 40.74))]  # from the face into the base, 15 degrees down


def draw(file):
    doc = ezdxf.new("R2010", setup=False)
    doc.header["$INSUNITS"] = 6  # metres
    space = doc.modelspace()
    for layer in ("OUTLINE", "BASE", "CRACK", "WATER", "ANCHORS", "MONITORS", "NOTES"):
        doc.layers.add(layer)
    space.add_lwpolyline(OUTLINE, close=True, dxfattribs={"layer": "OUTLINE"})
    space.add_lwpolyline(BASE, close=True, dxfattribs={"layer": "BASE"})
    space.add_line((57, 60), (55.5, 40.7), dxfattribs={"layer": "CRACK"})
    space.add_lwpolyline(WATER, dxfattribs={"layer": "WATER"})
    for head, toe in ANCHORS:
        space.add_line(head, toe, dxfattribs={"layer": "ANCHORS"})
    for point in ((29.5, 59.5), (2.5, 4.0)):
        space.add_point(point, dxfattribs={"layer": "MONITORS"})
    space.add_text("60 m face, bedding dips out of it", dxfattribs={"layer": "NOTES", "height": 2.0})
    doc.saveas(file)


if __name__ == "__main__":
    draw(sys.argv[1] if len(sys.argv) > 1 else "section.dxf")
