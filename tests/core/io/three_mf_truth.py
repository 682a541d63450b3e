#!/usr/bin/env python3
"""An independent reading of 3MF files: FILE... -> a line per file: vertices triangles min x y z max x y z, of what the build places."""
import re
import sys
import xml.etree.ElementTree as ElementTree
import zipfile

CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
PATH = "{http://schemas.microsoft.com/3dmanufacturing/production/2015/06}path"
IDENTITY = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]


def matrix(node):
    return [float(word) for word in node.get("transform", "").split()] or IDENTITY


def moved(m, p):
    return tuple(sum(p[k] * m[3 * k + i] for k in range(3)) + m[9 + i] for i in range(3))


def read(name):
    archive = zipfile.ZipFile(name)
    models = {}

    def model(part):
        if part not in models:
            text = archive.read(part.lstrip("/"))
            try:
                models[part] = ElementTree.fromstring(text)
            except ElementTree.ParseError:  # a prefix that no one declares, of materials that do not matter here
                models[part] = ElementTree.fromstring(re.sub(rb"<(/?)(\w+):", rb"<\1\2_", text))
        return models[part]

    def points(part, number, place):
        found = [o for o in model(part).iter(CORE + "object") if o.get("id") == number]
        assert len(found) == 1, (name, part, number)
        mesh = found[0].find(CORE + "mesh")
        if mesh is not None:
            corners = [tuple(float(v.get(axis)) for axis in "xyz") for v in mesh.iter(CORE + "vertex")]
            for m in place:
                corners = [moved(m, p) for p in corners]
            yield corners, len(list(mesh.iter(CORE + "triangle")))
        for component in found[0].iter(CORE + "component"):
            yield from points(component.get(PATH, part), component.get("objectid"), [matrix(component)] + place)

    relations = ElementTree.fromstring(archive.read("_rels/.rels"))
    root = [r.get("Target") for r in relations if r.get("Type").endswith("/2013/01/3dmodel")][0]
    corners, triangles = [], 0
    for item in model(root).iter(CORE + "item"):
        for some, count in points(item.get(PATH, root), item.get("objectid"), [matrix(item)]):
            corners += some
            triangles += count
    low = [min(p[i] for p in corners) for i in range(3)]
    high = [max(p[i] for p in corners) for i in range(3)]
    return len(corners), triangles, *low, *high


for argument in sys.argv[1:]:
    print(*(repr(value) for value in read(argument)))
