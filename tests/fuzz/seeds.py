"""Gathers the seeds of one fuzz target into a folder: seeds.py TARGET FOLDER. Small files of the target's extension under
../shared/data as they are, the beginnings of larger ones; for the files beside clouds those of tests/data and a few of our own.
Where there is no shared data, the target starts from what is ours."""
import pathlib
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHARED = ROOT.parent / "shared" / "data"
LARGEST = 64 << 10
# Each input is read some seven times; what takes long to unpack is tried seldom.
LARGEST_LAZ = 20 << 10
MOST_FILES = 120
TEXT = {"csv", "xyz", "txt", "asc", "pts", "ptx", "obj", "vtk"}
ALSO = {"csv": ["txt", "xyz", "asc"], "gltf": ["glb"], "pts": ["xyz"], "sbet": ["out"], "model": ["3mf"]}

OWN = {
    "case": [
        b'{"vestige":1,"name":"n","layers":[{"id":"a","role":"aerial","path":"a.las","unit":"m"},{"id":"b","role":"handheld",'
        b'"path":"b.ply","unit":"mm","init":{"picks":"p.csv"}}],"preprocess":{"filter":"gaussian","voxel_m":0.2},'
        b'"registration":{"method":"improved-ndt","target":"a"},"measurements":[{"object":"Length","tape_m":4.93,'
        b'"picks":{"a":[[[0,0,0],[1,2,3]]],"b":[]}}]}',
        b'{"vestige":1,"layers":[{"id":"a","role":"photogrammetry","path":"a.las","salvage":true,"init":"auto","tint":[1,2,3],'
        b'"visible":false}],"measurements":[{"object":"x","tape_m":1,"picks":{"a":[{"a":["a",[0,0,0]],"b":["a",[1,1,1]]}]}}]}',
    ],
    "trajectory": [
        b"poseId,timestamp,T00,T01,T02,T03,T10,T11,T12,T13,T20,T21,T22,T23,T30,T31,T32,T33\n"
        b"0,1.5,1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1\n1,2.5,1,0,0,3,0,1,0,4,0,0,1,5,0,0,0,1\n",
        b"# t x y z qx qy qz qw\n0 0 0 0 0 0 0 1\n1,1,2,3,0,0,0.7071068,0.7071068\n",
    ],
    "vtk": [
        b"# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0\n1 1 0 0 1 0\nPOLYGONS 1 5\n"
        b"4 0 1 2 3\nPOINT_DATA 4\nSCALARS intensity float 1\nLOOKUP_TABLE default\n1 2 3 4\nNORMALS n float\n"
        b"0 0 1 0 0 1 0 0 1 0 0 1\nFIELD f 2\ntime 1 4 double\n1 2 3 4\nrgb 3 4 unsigned_char\n1 2 3 4 5 6 7 8 9 1 2 3\n",
        b"# vtk DataFile Version 5.1\nt\nBINARY\nDATASET POLYDATA\nPOINTS 3 float\n" + struct.pack(">9f", *range(9)) +
        b"\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n" + struct.pack(">2q", 0, 3) + b"\nCONNECTIVITY vtktypeint64\n" +
        struct.pack(">3q", 0, 1, 2) + b"\nMETADATA\nINFORMATION 0\n\nPOINT_DATA 3\nCOLOR_SCALARS c 3\n" + bytes(range(9)),
        b"# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n"
        b"3 0 1 2\nCELL_TYPES 1\n5\nCELL_DATA 1\nSCALARS s int 1\nLOOKUP_TABLE default\n1\n",
    ],
    "obj": [b"v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nf -1 -2 -3\n"],
    "stl": [b"solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n"],
    "ply": [b"ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\n"
            b"property uchar red\nproperty uchar green\nproperty uchar blue\nproperty list uchar int q\nelement face 1\n"
            b"property list uchar uint vertex_indices\nend_header\n" + struct.pack("<3d4B3d4B", 1, 2, 3, 9, 9, 9, 0, 4, 5, 6, 1, 2, 3, 0) +
            struct.pack("<B3I", 3, 0, 1, 1)],
    "pcd": [b"VERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA binary_compressed\n"
            + struct.pack("<2I", 33, 32) + b"\x1f" + struct.pack("<8f", *range(8))],
    "csv": [b"x,y,z,intensity,red,green,blue\n1,2,3,4,255,0,1\n2,3,4,5,0,1,2\n", b"1 2 3 0 0 1\n4;5;6\n"],
    "ptx": [b"2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n1 2 3 0.5 1 2 3\n0 0 0 0.5 0 0 0\n"],
    "sbet": [b"".join(struct.pack("<17d", 1000 + i, 0.7, 2.0, 30 + i, *[0.1] * 13) for i in range(3))],
    "json": [
        b'{"asset":{"version":"1.0"},"geometricError":9,"root":{"refine":"ADD","boundingVolume":{"region":[0,0,1,1,0,9]},'
        b'"transform":[1,0,0,0,0,1,0,0,0,0,1,0,4e5,5e6,7,1],"content":{"uri":"tile.pnts"},"children":[{"content":'
        b'{"url":"./more.json"}},{"children":[{"content":{"uri":"tile.pnts"}}]}]}}',
        b'{"asset":{"version":"1.1"},"root":{"contents":[{"uri":"tile.pnts"},{"uri":"more.json"}],"extensions":'
        b'{"3DTILES_multiple_contents":{"contents":[{"uri":"tile.pnts"}]}},"geometricError":0,"refine":"REPLACE"}}',
    ],
    "gltf": [b'{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[1,2,3],'
             b'"rotation":[0,0,0,1],"scale":[1,1,1],"children":[1]},{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],"meshes":'
             b'[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":4}]}],"accessors":[{"bufferView":0,'
             b'"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},{"bufferView":1,"componentType":5121,'
             b'"count":3,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":1,"byteOffset":0,"byteLength":3}],'
             b'"buffers":[{"uri":"buffer.bin","byteLength":256},{"uri":"data:application/octet-stream;base64,AAEC","byteLength":3}]}'],
    "model": [
        b'<?xml version="1.0"?><model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:p='
        b'"http://schemas.microsoft.com/3dmanufacturing/production/2015/06" requiredextensions="p"><resources><basematerials id="5">'
        b'<base name="a" displaycolor="#FF8000"/></basematerials><object id="1" pid="5" pindex="0"><mesh><vertices><vertex x="0" y="0" '
        b'z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1e2" z="0"/></vertices><triangles><triangle v1="0" v2="1" v3="2" pid="5" '
        b'p1="0" p2="0" p3="0"/></triangles></mesh></object><object id="2"><components><component objectid="1" transform='
        b'"1 0 0 0 1 0 0 0 1 5 6 7"/><component objectid="7" p:path="/3D/b.model"/></components></object></resources><build><item '
        b'objectid="2"/><item objectid="1" transform="-1 0 0 0 1 0 0 0 1 5 6 7"/></build></model>\0<model xmlns="http://schemas.'
        b'microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="7"><mesh><vertices><vertex x="0" y="0" z="0"/></vertices>'
        b'</mesh></object></resources></model>',
    ],
    "points": [b"local index,x,y,z\n17,518440.25,4326120.5,-3.1\n", b"\"Mirror, left\";1;2;3\n", b"//X Y Z\n1 2 3\n"],
    "tapes": [b"object,method,tape_m,kind\n\"A, b\",lidar,0.234,circle\nC,lidar,,\n", b"A\t4.93\n"],
    "pts": [b"2\n1 2 3 -5 255 0 0\n4 5 6 7 0 0 255\n"],
}
FOLDERS = {"picks": ("registration", "*_picks.csv"), "pose": ("registration", "*_pose.json"), "accuracy": ("oracles", "*.csv")}


def first_las_points(content, most=20):
    """An uncompressed LAS file cut to its first points, with the counts that fit."""
    offset, = struct.unpack_from("<I", content, 96)
    record, count = struct.unpack_from("<HI", content, 105)
    kept = min(most, count or most)
    cut = bytearray(content[:offset + kept * record])
    struct.pack_into("<I", cut, 107, kept)
    if cut[25] >= 4:
        struct.pack_into("<Q", cut, 247, kept)
        struct.pack_into("<QI", cut, 235, 0, 0)
    return bytes(cut)


def seeds(target):
    for content in OWN.get(target, []):
        yield content
    if target in FOLDERS:
        folder, pattern = FOLDERS[target]
        for file in sorted((ROOT / "tests" / "data" / folder).glob(pattern)):
            yield file.read_bytes()
    if target in ("case", "trajectory", "points", "tapes") or target in FOLDERS or not SHARED.is_dir():
        return
    wanted = {target, *ALSO.get(target, [])}
    files = [file for file in SHARED.rglob("*") if file.is_file() and file.suffix[1:].lower() in wanted]
    for file in sorted(files, key=lambda one: (one.stat().st_size, one))[:MOST_FILES]:
        content = file.read_bytes()
        if target == "las":
            if len(content) > 300 and not content[104] & 0x80:
                content = first_las_points(content)
        elif target in TEXT and len(content) > 8 << 10:
            content = b"\n".join(content[:8 << 10].split(b"\n")[:60]) + b"\n"
        if 0 < len(content) <= (LARGEST_LAZ if target == "laz" else LARGEST):
            yield content


def main():
    target, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for number, content in enumerate(seeds(target)):
        (folder / f"seed-{number:03}").write_bytes(content)


main()
