# SPDX-License-Identifier: BSD-3-Clause
"""Faces of OBJ, OFF and STL files. The program has checked the files; errors here are ours."""

import struct

import numpy as np


def read_faces(data, extension):
    """\\param data bytes of a file  \\param extension such as ".obj"  \\return a list of (n, 3) arrays, one per face"""
    readers = {".obj": obj_faces, ".off": off_faces, ".stl": stl_faces}
    return readers[extension.lower()](data)


def obj_faces(data):
    points, faces = [], []
    for line in data.decode().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            corners = [int(word.split("/")[0]) for word in words[1:]]
            faces.append([corner - 1 if corner > 0 else len(points) + corner for corner in corners])
    points = np.array(points)
    return [points[face] for face in faces]


def off_faces(data):
    lines = (line.split("#")[0].split() for line in data.decode().splitlines())
    words = [word for line in lines for word in line]
    if words[0] != "OFF":
        raise ValueError(f"an OFF file that begins with {words[0]!r}")
    point_count, face_count = int(words[1]), int(words[2])
    points = np.array(words[4 : 4 + 3 * point_count], dtype=float).reshape(-1, 3)
    faces, at = [], 4 + 3 * point_count
    for _ in range(face_count):
        corners = int(words[at])
        faces.append(points[[int(word) for word in words[at + 1 : at + 1 + corners]]])
        at += 1 + corners
    return faces


def stl_faces(data):
    header, record = 84, struct.calcsize("<12fH")
    if len(data) >= header and len(data) == header + record * struct.unpack_from("<I", data, 80)[0]:
        rows = [struct.unpack_from("<12fH", data, at)[3:12] for at in range(header, len(data), record)]
        return list(np.array(rows).reshape(-1, 3, 3))
    corners = [line.split()[1:4] for line in data.decode().splitlines() if line.split()[:1] == ["vertex"]]
    return list(np.array(corners, dtype=float).reshape(-1, 3, 3))
