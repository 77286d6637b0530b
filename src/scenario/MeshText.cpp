// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/MeshText.h"

#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

namespace narrows
{
namespace
{
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<std::size_t>;

constexpr double largestNumber = 1e9;  // as everywhere in a scenario
constexpr std::size_t mostTriangles = 1000000;
/// Least area of a triangle over the square of its longest edge: below it, its corners lie on a line but for rounding.
constexpr double leastFatness = 1e-12;

/// Points and faces as a file lists them.
struct Soup
{
    std::vector<Point> points;
    std::vector<Polygon> faces;
};

bool readSoup(const std::string &text, MeshFormat format, Soup &soup)
{
    std::istringstream stream(text);
    switch (format)
    {
        case MeshFormat::Obj:
            return CGAL::IO::read_OBJ(stream, soup.points, soup.faces);
        case MeshFormat::Off:
            return CGAL::IO::read_OFF(stream, soup.points, soup.faces);
        case MeshFormat::Stl:
            return CGAL::IO::read_STL(stream, soup.points, soup.faces);
    }
    return false;
}

[[noreturn]] void refuseFace(std::size_t face, const char *reason)
{
    throw std::runtime_error(fmt::format("has a face (number {}) {}", face + 1, reason));
}

/// Gives every place one number, in the order of the faces that use it.
class Welder
{
public:
    Welder(const std::vector<Point> &points, Mesh &mesh) : points_(points), mesh_(mesh) {}

    int number(std::size_t index, std::size_t face)
    {
        if (index >= points_.size())
            refuseFace(face, "with a point that is not in the file");
        const Point &point = points_[index];
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(point[i]) <= largestNumber))
                refuseFace(face, "with a coordinate that is not finite or larger than 1e9");
        const auto [place, isNew] = numbers_.try_emplace({point.x(), point.y(), point.z()}, mesh_.vertices.size());
        if (isNew)
            mesh_.vertices.emplace_back(point.x(), point.y(), point.z());
        return static_cast<int>(place->second);
    }

private:
    const std::vector<Point> &points_;
    Mesh &mesh_;
    std::map<std::array<double, 3>, std::size_t> numbers_;
};

Eigen::Vector3d areaVector(const Mesh &mesh, const std::array<int, 3> &triangle)
{
    const Eigen::Vector3d &a = mesh.vertices[static_cast<std::size_t>(triangle[0])];
    const Eigen::Vector3d &b = mesh.vertices[static_cast<std::size_t>(triangle[1])];
    const Eigen::Vector3d &c = mesh.vertices[static_cast<std::size_t>(triangle[2])];
    return (b - a).cross(c - a) / 2.0;
}

bool isFlat(const Mesh &mesh, const std::array<int, 3> &triangle)
{
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const Eigen::Vector3d edge = mesh.vertices[static_cast<std::size_t>(triangle[(i + 1) % 3])] -
                                     mesh.vertices[static_cast<std::size_t>(triangle[i])];
        longest = std::max(longest, edge.squaredNorm());
    }
    return areaVector(mesh, triangle).norm() <= leastFatness * longest;
}

/// Divides a face from its first corner, which covers what the face covers if it is convex.
void addFace(const std::vector<int> &corners, std::size_t face, Mesh &mesh)
{
    const std::size_t first = mesh.triangles.size();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    {
        const std::array<int, 3> triangle = {corners[0], corners[i], corners[i + 1]};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
            continue;
        if (isFlat(mesh, triangle))
            refuseFace(face, "without area: three of its corners lie on a line");
        mesh.triangles.push_back(triangle);
        normal += areaVector(mesh, triangle);
    }
    for (std::size_t i = first; i < mesh.triangles.size(); ++i)
        if (areaVector(mesh, mesh.triangles[i]).dot(normal) <= 0.0)
            refuseFace(face, "that is not convex; divide it into triangles");
}
}  // namespace

std::optional<MeshFormat> meshFormat(const std::string &extension)
{
    static const std::map<std::string, MeshFormat> formats = {
        {".obj", MeshFormat::Obj}, {".off", MeshFormat::Off}, {".stl", MeshFormat::Stl}};
    const auto found = formats.find(extension);
    return found != formats.end() ? std::optional(found->second) : std::nullopt;
}

Mesh parseMesh(const std::string &text, MeshFormat format)
{
    static const std::map<MeshFormat, const char *> names = {{MeshFormat::Obj, "is not an OBJ file"},
                                                             {MeshFormat::Off, "is not an OFF file"},
                                                             {MeshFormat::Stl, "is not an STL file"}};
    Soup soup;
    if (!readSoup(text, format, soup))
        throw std::runtime_error(names.at(format));
    Mesh mesh{{}, {}, false};
    Welder welder(soup.points, mesh);
    for (std::size_t face = 0; face < soup.faces.size(); ++face)
    {
        std::vector<int> corners;
        for (const std::size_t index : soup.faces[face])
            corners.push_back(welder.number(index, face));
        addFace(corners, face, mesh);
        if (mesh.triangles.size() > mostTriangles)
            throw std::runtime_error(fmt::format("has more than {} triangles", mostTriangles));
    }
    if (mesh.triangles.empty())
        throw std::runtime_error("has no triangles");
    return mesh;
}

std::string offText(const Mesh &mesh)
{
    std::string text = fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.triangles.size());
    for (const Eigen::Vector3d &v : mesh.vertices)
        text += fmt::format("{} {} {}\n", v.x(), v.y(), v.z());
    for (const std::array<int, 3> &t : mesh.triangles)
        text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
    return text;
}
}  // namespace narrows
