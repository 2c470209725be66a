#!/usr/bin/python3
"""Writes the meshes of the scenes: make_meshes.py [DIRECTORY], by default into meshes/.

Each is a COLLADA file with its own colours, in metres, in the axes of the body that it represents; the origin is the
centre of mass of the scene's shape. Front and back, and left and right, have different colours. The output is the same
in every run.
"""
import math
import os
import random
import sys

STEEL, BRIGHT, DARK = (.60, .63, .68), (.86, .87, .88), (.13, .14, .17)
VERMILION, BLUE, GOLD = (.84, .37, .10), (.10, .30, .62), (.87, .68, .25)
WHITE, CREAM, BLACK = (.95, .95, .95), (.93, .89, .78), (.05, .05, .06)
SHADE = 1.7  # the part of a colour that is seen without light


# --- vectors --------------------------------------------------------------------------------------------------------


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def scaled(a, s):
    return tuple(x * s for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a))
    return scaled(a, 1 / length) if length else a


def about_y(angle):
    c, s = math.cos(angle), math.sin(angle)
    return lambda p: (c * p[0] + s * p[2], p[1], c * p[2] - s * p[0])


def z_to_x(p):
    return (p[2], p[0], p[1])


def z_to_y(p):
    return (p[1], p[2], p[0])


def same(p):
    return p


# --- a mesh ---------------------------------------------------------------------------------------------------------


class Mesh:
    """Triangles of several colours."""

    def __init__(self):
        self.faces = {}  # colour -> list of three (point, normal)

    def triangle(self, colour, *corners):
        self.faces.setdefault(colour, []).append(corners)

    def flat(self, colour, *points):
        """A flat polygon, convex, anticlockwise from outside."""
        normal = unit(cross(add(points[1], scaled(points[0], -1)), add(points[2], scaled(points[0], -1))))
        for i in range(1, len(points) - 1):
            self.triangle(colour, *((p, normal) for p in (points[0], points[i], points[i + 1])))

    def box(self, colour, size, centre, place=same):
        x, y, z = (.5 * s for s in size)
        for axis in range(3):
            for side in (1, -1):
                square = [(side, a, b) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))][::side]
                turned = [(s[-axis % 3], s[(1 - axis) % 3], s[(2 - axis) % 3]) for s in square]
                self.flat(colour, *(place(add(centre, (a * x, b * y, c * z))) for a, b, c in turned))

    def lathe(self, colour, profile, centre=(0, 0, 0), place=same, segments=28, colours=None):
        """Turned about z: (radius, z) from the bottom up, outside on the right; a corner wherever it bends sharply."""
        for k in range(len(profile) - 1):
            (r0, z0), (r1, z1) = profile[k], profile[k + 1]
            along = unit((r1 - r0, z1 - z0))

            def normal_at(j, other):
                if not 0 <= other < len(profile) - 1:
                    return along
                (a, b), (c, d) = profile[other], profile[other + 1]
                next_along = unit((c - a, d - b))
                smooth = dot(along, next_along) > .75
                return unit(add(along, next_along)) if smooth else along

            ends = [(r0, z0, normal_at(k, k - 1)), (r1, z1, normal_at(k, k + 1))]
            for i in range(segments):
                quad = []
                for r, z, t in (ends[0], ends[1]):
                    for a in (2 * math.pi * i / segments, 2 * math.pi * (i + 1) / segments):
                        c, s = math.cos(a), math.sin(a)
                        p, n = (r * c, r * s, z), (t[1] * c, t[1] * s, -t[0])
                        quad.append((place(add(p, centre)), place_direction(place, n)))
                of = colours(i, k) if colours else colour
                if r0 > 0:
                    self.triangle(of, quad[0], quad[1], quad[2])
                if r1 > 0:
                    self.triangle(of, quad[1], quad[3], quad[2])

    def rod(self, colour, radius, a, b, segments=10, tip=None):
        """A straight rod from a to b, closed with flat ends."""
        axis = add(b, scaled(a, -1))
        length, along = math.sqrt(dot(axis, axis)), unit(axis)
        side = unit(cross(along, (0, 0, 1) if abs(along[2]) < .9 else (1, 0, 0)))
        up = cross(along, side)

        def place(p):
            return add(a, add(add(scaled(side, p[0]), scaled(up, p[1])), scaled(along, p[2])))

        end = radius if tip is None else tip
        self.lathe(colour, [(0, 0), (radius, 0), (end, length), (0, length)], place=place, segments=segments)

    def tube(self, colour, path, radius, sides=8, closed=False, flat=1.0):
        """Round a path in the xy plane; `flat` makes it taller (along z) than wide."""
        n = len(path)
        rings = []
        for i in range(n):
            before = path[i - 1] if closed or i else path[i]
            after = path[(i + 1) % n] if closed or i < n - 1 else path[i]
            along = unit(add(after, scaled(before, -1)))
            side = unit(cross(along, (0, 0, 1)))
            ring = []
            for k in range(sides):
                c, s = math.cos(2 * math.pi * k / sides), math.sin(2 * math.pi * k / sides)
                ring.append((add(path[i], add(scaled(side, c * radius), (0, 0, s * radius * flat))),
                             unit(add(scaled(side, c * flat), (0, 0, s)))))
            rings.append(ring)
        for i in range(n if closed else n - 1):
            a, b = rings[i], rings[(i + 1) % n]
            for k in range(sides):
                m = (k + 1) % sides
                self.triangle(colour, a[k], b[k], a[m])
                self.triangle(colour, a[m], b[k], b[m])

    def plate(self, outline, thickness, front, back, edge, place=same, bevel=0.0):
        """A convex outline in the xy plane, anticlockwise, with a thickness along z; the edges may be rounded off."""
        h = .5 * thickness
        n = len(outline)
        middle = scaled(tuple(sum(c) for c in zip(*outline)), 1 / n)

        def inset(p):
            d = add(p, scaled(middle, -1))
            return add(middle, scaled(d, max(0, 1 - bevel / math.hypot(*d))))

        inner = [inset(p) for p in outline]
        top = [place((x, y, h)) for x, y in inner]
        bottom = [place((x, y, -h)) for x, y in inner]
        self.flat(front, *top)
        self.flat(back, *reversed(bottom))
        layers = [(inner, -h), (outline, -h + .6 * bevel), (outline, h - .6 * bevel), (inner, h)] if bevel else [
            (outline, -h), (outline, h)]
        rims = []
        for points, z in layers:
            rim = []
            for i, (x, y) in enumerate(points):
                (ax, ay), (bx, by) = outline[i - 1], outline[(i + 1) % n]
                out = unit((by - ay, ax - bx, 0))
                tilt = 0 if len(layers) == 2 else 2.5 * (1 if z == h else -1 if z == -h else 0)
                rim.append((place((x, y, z)), place_direction(place, unit(add(out, (0, 0, tilt))))))
            rims.append(rim)
        for a, b in zip(rims, rims[1:]):
            for i in range(n):
                j = (i + 1) % n
                self.triangle(edge, a[i], a[j], b[i])
                self.triangle(edge, a[j], b[j], b[i])

    def write(self, path):
        positions, normals, index, parts = [], [], {}, []
        for colour, faces in self.faces.items():
            out = []
            for corners in faces:
                for p, n in corners:
                    key = ("%.4g %.4g %.4g" % tuple(round(x, 4) + 0.0 for x in p),
                           "%.3g %.3g %.3g" % tuple(round(x, 2) + 0.0 for x in n))
                    if key not in index:
                        index[key] = len(positions)
                        positions.append(key[0])
                        normals.append(key[1])
                    out.append(str(index[key]))
            parts.append((colour, out))
        count = len(positions)

        def source(name, values):
            return ('<source id="%s"><float_array id="%s-a" count="%d">%s</float_array><technique_common>'
                    '<accessor source="#%s-a" count="%d" stride="3"><param name="X" type="float"/>'
                    '<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common>'
                    '</source>\n' % (name, name, 3 * count, "\n".join(values), name, count))

        def effect(i, c):
            text = " ".join("%.3g" % x for x in c)
            shade = " ".join("%.3g" % min(1, SHADE * x) for x in c)  # RViz's only light is behind the viewer
            return ('<effect id="e%d"><profile_COMMON><technique sid="t"><phong><ambient><color>%s 1</color></ambient>'
                    '<diffuse><color>%s 1</color></diffuse><specular><color>.08 .08 .08 1</color></specular>'
                    '<shininess><float>12</float></shininess></phong></technique></profile_COMMON></effect>\n'
                    % (i, shade, text))

        text = ['<?xml version="1.0" encoding="utf-8"?>\n<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" '
                'version="1.4.1">\n<asset><contributor><authoring_tool>make_meshes.py</authoring_tool></contributor>'
                '<created>2000-01-01T00:00:00</created><modified>2000-01-01T00:00:00</modified>'
                '<unit name="metre" meter="1"/><up_axis>Z_UP</up_axis></asset>\n<library_effects>\n']
        text += [effect(i, colour) for i, (colour, _) in enumerate(parts)]
        text.append('</library_effects>\n<library_materials>\n')
        text += ['<material id="m%d"><instance_effect url="#e%d"/></material>\n' % (i, i) for i in range(len(parts))]
        text.append('</library_materials>\n<library_geometries><geometry id="g"><mesh>\n')
        text += [source("p", positions), source("n", normals)]
        text.append('<vertices id="v"><input semantic="POSITION" source="#p"/><input semantic="NORMAL" source="#n"/>'
                    '</vertices>\n')
        for i, (_, indices) in enumerate(parts):
            lines = [" ".join(indices[k:k + 24]) for k in range(0, len(indices), 24)]
            text.append('<triangles material="s%d" count="%d"><input semantic="VERTEX" source="#v" offset="0"/><p>%s</p>'
                        '</triangles>\n' % (i, len(indices) // 3, "\n".join(lines)))
        text.append('</mesh></geometry></library_geometries>\n<library_visual_scenes><visual_scene id="w"><node>'
                    '<instance_geometry url="#g"><bind_material><technique_common>\n')
        text += ['<instance_material symbol="s%d" target="#m%d"/>\n' % (i, i) for i in range(len(parts))]
        text.append('</technique_common></bind_material></instance_geometry></node></visual_scene>'
                    '</library_visual_scenes>\n<scene><instance_visual_scene url="#w"/></scene>\n</COLLADA>\n')
        with open(path + ".part", "w") as out:
            out.write("".join(text))
        os.rename(path + ".part", path)


def place_direction(place, n):
    return unit(add(place(n), scaled(place((0, 0, 0)), -1)))


def rounded(width, height, radius, steps=6):
    """A rectangle with round corners about the origin, anticlockwise."""
    out = []
    for k, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        for i in range(steps + 1):
            a = .5 * math.pi * (k + i / steps)
            out.append((sx * (.5 * width - radius) + radius * math.cos(a),
                        sy * (.5 * height - radius) + radius * math.sin(a)))
    return out


def oval(a, b, n):
    return [(a * math.cos(2 * math.pi * i / n), b * math.sin(2 * math.pi * i / n)) for i in range(n)]


# --- the bodies -----------------------------------------------------------------------------------------------------


def wingnut():
    """Of scenes/dzhanibekov.yaml: hub along z, wings in the xz plane that rise outwards by .7 rad."""
    mesh, down = Mesh(), (0, 0, -.1057)
    hub = [(.15, -.45), (.27, -.45), (.29, -.43), (.29, -.36), (.265, -.33), (.24, .40), (.22, .45), (.15, .45)]
    mesh.lathe(STEEL, hub, down, segments=20)
    pitch, deep = .1, .3  # the thread, as far in as one can look from either end
    thread = [(.15 if k % 2 == 0 else .125, .45 - .5 * pitch * k) for k in range(round(2 * deep / pitch) + 1)]
    mesh.lathe(DARK, thread + [(r, -z) for r, z in reversed(thread)], down, segments=12)
    for side, colour in ((1, VERMILION), (-1, BRIGHT)):
        turn = about_y(-side * .7)

        def place(p, side=side, turn=turn):
            q = turn((side * (.5 * .9 + p[0]), 0, p[1]))
            return (q[0] + side * .224, -side * p[2], q[2] + down[2])

        mesh.plate(oval(.45, .375, 26), .12, colour, colour, colour, place, bevel=.04)
        ear = [scaled(p, .55) for p in oval(.45, .375, 18)]
        ear = [(x + .06, y) for x, y in ear]
        mesh.plate(ear, .135, *([scaled(colour, .82)] * 3), place=place)
    return mesh


def t_handle():
    """Of scenes/t_handle.yaml: bar along y, stem up along z."""
    mesh, down = Mesh(), (0, 0, -.1701)
    r, half, cap = .09, .65, .03
    bar = [(0, -half), (r - cap, -half), (r, -half + cap), (r, -.14)]
    mesh.lathe(VERMILION, bar, down, z_to_y_about(down), 24)
    mesh.lathe(STEEL, [(r, -.14), (.105, -.13), (.105, .13), (r, .14)], down, z_to_y_about(down), 24)
    mesh.lathe(BRIGHT, [(r, .14), (r, half - cap), (r - cap, half), (0, half)], down, z_to_y_about(down), 24)
    stem = [(.12, .05), (.12, .12), (r, .15), (r, .45)]
    for k in range(9):  # the thread
        z = .45 + .04 * k
        stem += [(.075, z + .012), (r, z + .024), (r, z + .034)]
    mesh.lathe(STEEL, stem + [(.07, .84), (0, .84)], down, segments=24)
    return mesh


def z_to_y_about(centre):
    """Turns z to y about a centre that lathe has already added."""
    def place(p):
        q = z_to_y(add(p, scaled(centre, -1)))
        return add(q, centre)
    return place


def racket():
    """Of scenes/tennis_racket.yaml: handle along x, z out of the face; its strings are orange on that side."""
    mesh, c = Mesh(), .2310
    a, b = .33, .26
    mesh.tube(BLUE, [(c + x, y, 0) for x, y in oval(a, b, 56)], .019, closed=True, flat=1.5)
    for side, colour in ((1, VERMILION), (-1, WHITE)):
        z = side * .005
        for i in range(-4, 5):  # along the handle
            y = .054 * i
            half = (a - .012) * math.sqrt(max(0, 1 - (y / b) ** 2))
            if half > .05:
                mesh.box(colour, (2 * half, .011, .009), (c, y, z))
        for i in range(-5, 6):
            x = .056 * i
            half = (b - .012) * math.sqrt(max(0, 1 - (x / a) ** 2))
            if half > .05:
                mesh.box(colour, (.011, 2 * half, .009), (c + x, 0, z))
        spot = [(c + .02 + x, y) for x, y in oval(.1, .1, 26)]
        mesh.plate(spot, .003, colour, colour, colour, lambda p, z=z: (p[0], p[1], p[2] + 2.2 * z))
    for side in (1, -1):  # the throat
        path = [(c - .27, side * .155, 0), (c - .36, side * .10, 0), (-.20, side * .045, 0), (-.27, side * .018, 0)]
        mesh.tube(BLUE, path, .017, flat=1.3)
    mesh.box(BLUE, (.16, .062, .05), (-.33, 0, 0))
    mesh.lathe(DARK, [(0, -.769), (.042, -.769), (.044, -.745), (.034, -.735), (.034, -.41), (.028, -.40), (0, -.40)],
               place=z_to_x, segments=8)
    for k in range(7):  # the grip
        mesh.lathe(STEEL, [(.034, -.72 + .045 * k), (.0365, -.715 + .045 * k), (.034, -.71 + .045 * k)], place=z_to_x,
                   segments=8)
    return mesh


def book():
    """Of scenes/tossed_book.yaml: .96 high along x, .64 wide along y; the front cover looks along +z."""
    mesh, x, y, h = Mesh(), .96, .64, .05
    page = rounded(x - .03, y - .03, .005, 1)
    mesh.plate(page, .08, CREAM, CREAM, CREAM, lambda p: (p[0], p[1] + .008, p[2]))
    for side, colour in ((1, VERMILION), (-1, BLUE)):
        mesh.plate(rounded(x, y, .015, 3), .012, colour, colour, colour, lambda p, s=side: (p[0], p[1], p[2] + s * (h - .006)))
    mesh.box(DARK, (x, .02, 2 * h), (0, -.5 * y + .01, 0))
    mesh.lathe(DARK, [(0, -.48), (h, -.48), (h, .48), (0, .48)], (0, 0, 0), lambda p: (p[2], -.5 * y + .02 + .6 * min(p[0], 0), p[1]), 16)
    top = h + .002
    mesh.box(CREAM, (.30, .46, .004), (.17, .01, top))  # the title's label, and two lines of title
    mesh.box(DARK, (.055, .34, .004), (.225, .01, top + .003))
    mesh.box(DARK, (.04, .22, .004), (.115, .01, top + .003))
    mesh.lathe(GOLD, [(.11, top - .002), (.11, top + .003), (0, top + .003)], (-.22, .01, 0), segments=32)
    mesh.lathe(VERMILION, [(.07, top + .001), (.07, top + .005), (0, top + .005)], (-.22, .01, 0), segments=32)
    for k in range(5):  # the back's lines of text
        mesh.box(BRIGHT, (.03, .42 - .05 * (k % 2), .004), (.24 - .085 * k, .01, -top))
    return mesh


def phone():
    """Of scenes/phone.yaml: eight times 146.7 x 71.5 x 7.4 mm; the screen looks along +z, its upper end is +x."""
    mesh, x, y, t = Mesh(), 1.1736, .572, .0592
    mesh.plate(rounded(x, y, .1, 7), t, BLACK, BRIGHT, STEEL, bevel=.012)
    z = .5 * t
    mesh.plate(rounded(x - .06, y - .06, .075, 6), .004, *[BLUE] * 3, place=lambda p: (p[0], p[1], p[2] + z))
    mesh.plate(rounded(.03, .2, .014, 4), .004, *[BLACK] * 3, place=lambda p: (p[0] + .5 * x - .06, p[1], p[2] + z + .003))
    for i in range(4):  # what is on the screen
        for k in range(4):
            colour = (VERMILION, GOLD, WHITE, (.35, .70, .55))[(i * 3 + k) % 4]
            centre = (.36 - .15 * i, -.18 + .12 * k)
            mesh.plate(rounded(.085, .085, .02, 3), .004, *[colour] * 3,
                       place=lambda p, c=centre: (p[0] + c[0], p[1] + c[1], p[2] + z + .002))
    for k in range(4):
        mesh.plate(rounded(.085, .085, .02, 3), .004, *[WHITE] * 3,
                   place=lambda p, k=k: (p[0] - .46, p[1] - .18 + .12 * k, p[2] + z + .002))

    def behind(p):
        return (p[0], -p[1], -p[2])

    mesh.plate(rounded(.24, .24, .06, 5), .016, *[STEEL] * 3, place=lambda p: behind((p[0] + .43, p[1] - .14, p[2] + z)))
    for dx, dy in ((.055, .055), (-.055, .055), (.055, -.055)):
        mesh.lathe(DARK, [(.047, z), (.047, z + .018), (.03, z + .018)], (.43 + dx, -.14 + dy, 0), behind, 24)
        mesh.lathe(BLUE, [(.03, z + .014), (0, z + .014)], (.43 + dx, -.14 + dy, 0), behind, 24)
    mesh.lathe(VERMILION, [(.09, z), (.09, z + .004), (0, z + .004)], (-.05, 0, 0), behind, 28)
    return mesh


def panel(mesh, size, centre, cells, front, back):
    """A solar panel in the xy plane, with its grid of cells on the upper side."""
    mesh.box(back, size, centre)
    dx, dy = size[0] / cells[0], size[1] / cells[1]
    for i in range(cells[0]):
        for k in range(cells[1]):
            at = (centre[0] - .5 * size[0] + dx * (i + .5), centre[1] - .5 * size[1] + dy * (k + .5))
            mesh.flat(front, *((at[0] + a * .44 * dx, at[1] + b * .44 * dy, centre[2] + .5 * size[2] + .003)
                               for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))))


def satellite():
    """Of scenes/gravity_gradient.yaml: two cylinders along x, two panels along y, a docking port at +x."""
    mesh, s = Mesh(), -.0345
    body = [(0, -.175), (.10, -.175), (.21, -.10), (.21, .52), (.13, .575), (.13, .61), (.10, .61), (.10, .59), (0, .59)]
    mesh.lathe(WHITE, body[:4], place=lambda p: add(z_to_x(p), (s, 0, 0)), segments=32)
    mesh.lathe(VERMILION, [(.213, .36), (.213, .40)], place=lambda p: add(z_to_x(p), (s, 0, 0)), segments=32)
    mesh.lathe(STEEL, body[3:], place=lambda p: add(z_to_x(p), (s, 0, 0)), segments=32)
    mesh.lathe(GOLD, [(0, -.67), (.13, -.67), (.16, -.63), (.16, -.21), (.10, -.17)], segments=28,
               place=lambda p: add(z_to_x(p), (s, 0, 0)))
    mesh.lathe(DARK, [(.03, -.67), (.08, -.74), (.075, -.74), (0, -.68)], place=lambda p: add(z_to_x(p), (s, 0, 0)), segments=20)
    for side in (1, -1):
        mesh.rod(STEEL, .014, (s - .42, side * .14, 0), (s - .42, side * .20, 0))
        panel(mesh, (.30, .62, .014), (s - .42, side * .50, 0), (4, 8), BLUE, STEEL)
    mesh.rod(STEEL, .009, (s + .1, 0, .2), (s + .1, 0, .32))
    mesh.lathe(BRIGHT, [(0, .30), (.05, .31), (.09, .35), (.085, .352), (.05, .32), (0, .312)], (s + .1, 0, 0), segments=20)
    return mesh


def explorer():
    """Of scenes/explorer1.yaml: a tube along z with a pointed nose and four whip antennas."""
    mesh, up = Mesh(), .0242
    r, top, bottom = .08, .8 + up, -.8 + up
    nose = [(r, .45), (.075, .56), (.06, .66), (.038, .75), (.014, .80), (0, .805)]

    def stripes(i, k):
        return WHITE if (i // 4) % 2 == 0 else DARK

    mesh.lathe(STEEL, [(0, bottom), (.055, bottom), (.07, bottom + .02), (r, bottom + .05), (r, -.12)], segments=24)
    mesh.lathe(WHITE, [(r, -.12), (r, .30 + up)], segments=24, colours=stripes)
    mesh.lathe(GOLD, [(r, .30 + up), (.085, .31 + up), (.085, .44 + up), (r, .45 + up)], segments=24)
    mesh.lathe(VERMILION, [(a, z + up) for a, z in nose], segments=24)
    for k in range(4):
        c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[k]
        z = -.1 + up
        mesh.rod(GOLD if k else VERMILION, .016, (.07 * c, .07 * s, z), (.58 * c, .58 * s, z), 8, tip=.008)
    return mesh


def asteroid():
    """Of scenes/toutatis.yaml: .88 x .76 x 1.9 m, two lobes, paler towards the smaller one, lumps and craters."""
    dice = random.Random(4179)

    def anywhere():
        z, a = 2 * dice.random() - 1, 2 * math.pi * dice.random()
        r = math.sqrt(1 - z * z)
        return (r * math.cos(a), r * math.sin(a), z)

    def on_ellipsoid(d):
        return (.44 * d[0], .38 * d[1], .95 * d[2])

    lumps = [(anywhere(), .10 + .25 * dice.random(), .20 * (dice.random() - .45)) for _ in range(46)]
    craters = [(on_ellipsoid(anywhere()), .07 + .17 * dice.random() ** 2) for _ in range(36)]

    def height(d):
        """On the unit sphere: how far out, and how much of a waist."""
        out = 1.0
        for at, width, tall in lumps:
            out += tall * math.exp(-(1 - dot(at, d)) / (width * width))
        for at, radius in craters:
            x = math.dist(at, on_ellipsoid(d)) / radius  # craters are round in the end
            if x < 1:
                out -= .8 * radius * (1 - x * x)
            elif x < 1.6:
                out += .6 * radius * ((1.6 - x) / .6) ** 2 * (x - 1)
        neck = math.exp(-((d[2] - .30) / .22) ** 2)  # between the two lobes
        return out, neck

    n, points, order = 14, [], {}
    g = (1 + math.sqrt(5)) / 2
    corners = [unit(p) for p in ((-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g),
                                 (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1))]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]

    def vertex(d):
        key = tuple(round(x, 6) for x in d)
        if key not in order:
            order[key] = len(points)
            points.append(d)
        return order[key]

    triangles = []
    for a, b, c in (tuple(corners[i] for i in face) for face in faces):
        grid = {(i, k): vertex(unit(add(add(scaled(a, n - i - k), scaled(b, i)), scaled(c, k))))
                for i in range(n + 1) for k in range(n + 1 - i)}
        for i in range(n):
            for k in range(n - i):
                triangles.append((grid[i, k], grid[i + 1, k], grid[i, k + 1]))
                if i + k < n - 1:
                    triangles.append((grid[i + 1, k], grid[i + 1, k + 1], grid[i, k + 1]))
    place = []
    for d in points:
        out, neck = height(d)
        place.append((.44 * d[0] * out * (1 - .22 * neck), .38 * d[1] * out * (1 - .22 * neck), .95 * d[2] * out))
    normals = [(0, 0, 0)] * len(points)
    for t in triangles:
        p, q, r = (place[i] for i in t)
        face = cross(add(q, scaled(p, -1)), add(r, scaled(p, -1)))
        for i in t:
            normals[i] = add(normals[i], face)
    mesh = Mesh()
    stone, pale = (.47, .42, .36), (.67, .62, .54)
    for t in triangles:
        high = sum(points[i][2] for i in t) / 3
        share = max(0, min(7, round(7 * (high + .1) / .8))) / 7  # paler bit by bit
        colour = tuple(round(a + share * (b - a), 3) for a, b in zip(stone, pale))
        mesh.triangle(colour, *((place[i], unit(normals[i])) for i in t))
    return mesh


BODIES = {f.__name__: f for f in (asteroid, book, explorer, phone, racket, satellite, t_handle, wingnut)}


def main():
    if len(sys.argv) > 2 or sys.argv[1:2] in (["-h"], ["--help"]):
        print(__doc__)
        return 0 if len(sys.argv) == 2 else 2
    default = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "meshes")
    folder = sys.argv[1] if len(sys.argv) == 2 else default
    if not os.path.isdir(folder):
        print("make_meshes.py: expected a directory, got %s" % folder, file=sys.stderr)
        return 2
    for name, make in sorted(BODIES.items()):
        make().write(os.path.join(folder, name + ".dae"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
