// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kernel/SpatialModel.h"

namespace narrows
{
enum class MeshFormat
{
    Obj,
    Off,
    Stl
};

/// By a file name's extension in lower case, with its dot.
std::optional<MeshFormat> meshFormat(const std::string &extension);

/// The triangles of a file: faces with more corners are divided if they are convex, points at the same place are made
/// one, triangles of two points are left out. `closed` is false.
/// \param text the file's bytes (STL may be binary)
/// \throws std::runtime_error with a reason that follows the file's name in a message: "is not an OBJ file", "has a
/// face (number 3) ..."
Mesh parseMesh(const std::string &text, MeshFormat format);

/// As an OFF file that `parseMesh` reads without any loss.
std::string offText(const Mesh &mesh);
}  // namespace narrows
