"""Reads an E57 file by the words of ASTM E2807, with nothing of Vestige, and prints what it holds.

A line `scan NAME` for each scan, then a line per record: its values in the order of the prototype, the
coordinates after the scan's pose. Every checksum and length is asserted.
"""
import math
import struct
import sys
import xml.etree.ElementTree as ElementTree

NAMESPACE = "{http://www.astm.org/COMMIT/E57/2010-e57-v1.0}"


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


def logical_content(raw):
    signature, major, minor, length, xml_at, xml_length, page = struct.unpack("<8sIIQQQQ", raw[:48])
    assert (signature, major, minor, page) == (b"ASTM-E57", 1, 0, 1024)
    assert length == len(raw) and length % page == 0
    content = b""
    for begin in range(0, length, page):
        body = raw[begin : begin + page - 4]
        assert struct.unpack(">I", raw[begin + page - 4 : begin + page])[0] == crc32c(body), begin
        content += body
    xml_at = logical(xml_at)
    return content, content[xml_at : xml_at + xml_length]


def logical(physical):
    assert physical % 1024 < 1020
    return physical // 1024 * 1020 + physical % 1024


def streams_of(content, section, fields, records):
    kind, length, data, index = struct.unpack("<B7xQQQ", content[section : section + 32])
    assert kind == 1 and section + length <= len(content)
    streams = [b""] * fields
    at, end, first_of_packet = logical(data) if records else section + length, section + length, {}
    while at < end:
        kind, _, packet, count = struct.unpack("<BBHH", content[at : at + 6])
        packet += 1
        assert packet % 4 == 0 and at + packet <= end
        if kind == 1:
            assert count == fields
            first_of_packet[at] = len(streams[0])
            lengths = struct.unpack("<%dH" % count, content[at + 6 : at + 6 + 2 * count])
            place = at + 6 + 2 * count
            assert place - at + sum(lengths) <= packet
            for number, size in enumerate(lengths):
                streams[number] += content[place : place + size]
                place += size
        elif kind == 0:
            assert at == logical(index) and packet == 16 + 16 * count
            for entry in range(count):
                record, where = struct.unpack("<QQ", content[at + 16 + 16 * entry : at + 32 + 16 * entry])
                assert logical(where) in first_of_packet and record < records
        else:
            raise AssertionError(kind)
        at += packet
    assert at == end
    return streams


def values_of(node, stream, records):
    kind = node.get("type")
    if kind == "Float":
        letter, size = ("f", 4) if node.get("precision") == "single" else ("d", 8)
        return list(struct.unpack("<%d%s" % (records, letter), stream[: size * records]))
    low, high = int(node.get("minimum")), int(node.get("maximum"))
    assert low <= int(node.text or 0) <= high
    bits = math.ceil(math.log2(high - low + 1)) if high - low < 2**40 else (high - low).bit_length()
    whole = int.from_bytes(stream, "little")
    numbers = [low + (whole >> (i * bits) & (1 << bits) - 1) for i in range(records)]
    assert all(low <= number <= high for number in numbers)
    if kind == "Integer":
        return numbers
    scale, offset = float(node.get("scale", "1")), float(node.get("offset", "0"))
    return [number * scale + offset for number in numbers]


def turned(pose, point):
    def number(part, name):
        found = pose.find(NAMESPACE + part + "/" + NAMESPACE + name)
        return 0.0 if found is None else float(found.text or 0)

    w, x, y, z = (number("rotation", name) for name in "wxyz")
    assert abs(w * w + x * x + y * y + z * z - 1) < 1e-12
    a, b, c = point
    # v + 2 q x (q x v + w v)
    tx, ty, tz = y * c - z * b + w * a, z * a - x * c + w * b, x * b - y * a + w * c
    moved = (a + 2 * (y * tz - z * ty), b + 2 * (z * tx - x * tz), c + 2 * (x * ty - y * tx))
    return [moved[i] + number("translation", "xyz"[i]) for i in range(3)]


def main(path):
    with open(path, "rb") as file:
        content, xml = logical_content(file.read())
    root = ElementTree.fromstring(xml)
    assert root.tag == NAMESPACE + "e57Root"
    assert root.find(NAMESPACE + "formatName").text == "ASTM E57 3D Imaging Data File"
    assert len(root.find(NAMESPACE + "guid").text) == 38
    for scan in root.find(NAMESPACE + "data3D"):
        name = scan.find(NAMESPACE + "name")
        print("scan", "" if name is None else name.text)
        points = scan.find(NAMESPACE + "points")
        prototype = list(points.find(NAMESPACE + "prototype"))
        records = int(points.get("recordCount"))
        streams = streams_of(content, logical(int(points.get("fileOffset"))), len(prototype), records)
        columns = [values_of(node, stream, records) for node, stream in zip(prototype, streams)]
        pose = scan.find(NAMESPACE + "pose")
        for row in zip(*columns):
            coordinates = list(row[:3]) if pose is None else turned(pose, row[:3])
            print(*(repr(value) for value in coordinates + list(row[3:])))


if __name__ == "__main__":
    main(sys.argv[1])
