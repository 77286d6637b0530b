// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/MeshFiles.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "scenario/InputText.h"
#include "scenario/MeshText.h"
#include "scenario/Scenario.h"

namespace narrows
{
namespace
{
std::string lowerCaseExtension(const std::filesystem::path &path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// \return the mesh, or nothing after the fault is reported at `field`
std::optional<Mesh> parsed(const Field &field, const std::string &text, MeshFormat format)
{
    try
    {
        return parseMesh(text, format);
    }
    catch (const std::exception &error)  // CGAL's readers ask for as much memory as a file's first line tells them to
    {
        field.fault(fmt::format("{} {}", describe(field.node()), error.what()));
        return std::nullopt;
    }
}
}  // namespace

MeshFiles::MeshFiles(const Field &files, const std::string &scenarioFile)
  : kept_(files.given()), files_(files), folder_(std::filesystem::path(scenarioFile).parent_path().string())
{
}

std::optional<Mesh> MeshFiles::read(const Field &name)
{
    const std::optional<std::string> text = name.text();
    if (!text)
        return std::nullopt;
    names_.push_back(*text);
    if (kept_)
        return readKept(name);
    const auto known = fromDisk_.find(*text);
    return known != fromDisk_.end() ? known->second : fromDisk_[*text] = readFromDisk(name);
}

std::optional<Mesh> MeshFiles::readKept(const Field &name) const
{
    const Field file = files_.optional(name.node().Scalar());
    if (!file.given())
        name.fault(fmt::format("{} is not among `files`", describe(name.node())));
    const std::optional<std::string> text = file.text();
    return text ? parsed(name, *text, MeshFormat::Off) : std::nullopt;
}

std::optional<Mesh> MeshFiles::readFromDisk(const Field &name) const
{
    const std::filesystem::path path = std::filesystem::path(folder_) / name.node().Scalar();
    const std::optional<MeshFormat> format = meshFormat(lowerCaseExtension(path));
    if (!format)
    {
        name.fault(fmt::format("must be the name of a file .obj, .off or .stl, not {}", describe(name.node())));
        return std::nullopt;
    }
    try
    {
        return parsed(name, readInputText(path.string()), *format);
    }
    catch (const InputError &error)
    {
        name.fault(fmt::format("{}: {}", describe(name.node()), error.faults().front().reason));
        return std::nullopt;
    }
}

std::string MeshFiles::appendix() const
{
    if (fromDisk_.empty())
        return {};
    YAML::Emitter yaml;
    yaml << YAML::BeginMap << YAML::Key << "files" << YAML::Value << YAML::BeginMap;
    for (const auto &[name, mesh] : fromDisk_)
        if (mesh)
            yaml << YAML::Key << name << YAML::Value << YAML::Literal << offText(*mesh);
    yaml << YAML::EndMap << YAML::EndMap;
    return std::string(yaml.c_str()) + "\n";
}
}  // namespace narrows
