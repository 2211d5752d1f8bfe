"""Writes section-r12.dxf, section-r2000.dxf and section-r2018.dxf by ezdxf (Debian: python3-ezdxf). potrace.dxf is `potrace -b dxf` of an ellipse of pixels,
pstoedit.dxf `pstoedit -f "dxf_s:-mm"` of a page with a polygon, a Bezier curve and a line.

usage: /usr/bin/python3 make_sections.py     in this folder
"""
import ezdxf


def draw(version, name, unit):
    doc = ezdxf.new(version, setup=False)
    if version != "R12": doc.header["$INSUNITS"] = unit
    msp = doc.modelspace()
    f = {6: 1.0, 4: 1000.0}[unit]
    for l in ("OUTLINE","TUNNEL","BASE","Joint-A","Joint-B","WATER","MONITORS","BOLTS","NOTES"):
        doc.layers.add(l)
    s = lambda pts: [(x*f, y*f) for x,y in pts]
    # outline: a polyline and two lines that meet end to end
    pl = s([(0,0),(60,0),(60,10),(40,10)])
    if version == "R12":
        msp.add_polyline2d(pl, dxfattribs={"layer":"OUTLINE"})
    else:
        msp.add_lwpolyline(pl, dxfattribs={"layer":"OUTLINE"})
    msp.add_line((40*f,10*f),(25*f,35*f), dxfattribs={"layer":"OUTLINE"})
    q = s([(0,0),(0,35),(25,35)])
    if version == "R12": msp.add_polyline2d(q, dxfattribs={"layer":"OUTLINE"})
    else: msp.add_lwpolyline(q, dxfattribs={"layer":"OUTLINE"})
    # horseshoe tunnel with a bulge: semicircular roof
    t = [(10*f,6*f,0),(14*f,6*f,0),(14*f,8*f,1.0),(10*f,8*f,0)]
    if version == "R12":
        p = msp.add_polyline2d([], dxfattribs={"layer":"TUNNEL"}); p.append_formatted_vertices(t, format="xyb"); p.close(True)
    else:
        msp.add_lwpolyline(t, format="xyb", close=True, dxfattribs={"layer":"TUNNEL"})
    # region
    b = s([(0,0),(60,0),(60,4),(0,4)])
    if version == "R12": msp.add_polyline2d(b, close=True, dxfattribs={"layer":"BASE"})
    else: msp.add_lwpolyline(b, close=True, dxfattribs={"layer":"BASE"})
    # joints: lines, an arc, a spline, a block inserted thrice, turned and mirrored
    msp.add_line((-1*f,12*f),(45*f,30*f), dxfattribs={"layer":"Joint-A"})
    msp.add_arc((25*f,35*f), 12*f, 180, 300, dxfattribs={"layer":"Joint-A"})
    if version != "R12":
        from ezdxf.math import BSpline, Vec3
        sp = BSpline([Vec3(x*f,y*f,0) for x,y in ((2,5),(12,20),(30,8),(45,22))], order=4)
        e = msp.add_spline(dxfattribs={"layer":"Joint-B"})
        e.apply_construction_tool(sp)
        el = msp.add_ellipse((20*f,20*f), (6*f,2*f), 0.5, 0.2, 2.0, dxfattribs={"layer":"Joint-B"})
    blk = doc.blocks.new("ECHELON", base_point=(1*f,1*f))
    blk.add_line((1*f,1*f),(4*f,2*f))
    blk.add_line((4*f,2*f),(5*f,2*f), dxfattribs={"layer":"Joint-A"})
    msp.add_blockref("ECHELON",(20*f,12*f), dxfattribs={"layer":"Joint-B","rotation":30,"xscale":2,"yscale":1})
    msp.add_blockref("ECHELON",(50*f,2*f), dxfattribs={"layer":"Joint-B","xscale":-1})
    msp.add_blockref("ECHELON",(5*f,25*f), dxfattribs={"layer":"Joint-B","column_count":2,"row_count":2,"column_spacing":6*f,"row_spacing":3*f})
    w = s([(0,30),(20,26),(40,10),(60,10)])
    if version == "R12": msp.add_polyline2d(w, dxfattribs={"layer":"WATER"})
    else: msp.add_lwpolyline(w, dxfattribs={"layer":"WATER"})
    msp.add_point((24*f,34*f), dxfattribs={"layer":"MONITORS"}); msp.add_point((38*f,11*f), dxfattribs={"layer":"MONITORS"})
    msp.add_line((30*f,25*f),(10*f,18*f), dxfattribs={"layer":"BOLTS"})
    msp.add_text("section 1", dxfattribs={"layer":"NOTES","insert":(10*f,40*f)})
    msp.add_circle((55*f,30*f), 1*f, dxfattribs={"layer":"NOTES"})
    doc.saveas(name)
draw("R12","section-r12.dxf",6)
draw("R2018","section-r2018.dxf",4)
draw("R2000","section-r2000.dxf",6)
