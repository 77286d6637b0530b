// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kernel/SpatialModel.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
/// The files of triangles that a scenario names. They are beside it on disk, or in its own text, under `files`: then
/// the text says all, as it must in a database.
class MeshFiles
{
public:
    /// \param files the scenario's entry `files`, given or not
    /// \param scenarioFile what file names are relative to
    MeshFiles(const Field &files, const std::string &scenarioFile);

    /// The triangles of the named file, every point once; `closed` is not decided yet. Nothing if there is no such file
    /// or it is not sound.
    std::optional<Mesh> read(const Field &name);

    /// Reports what `files` holds beside the files that were read.
    void refuseOthers() const { files_.allowOnly(names_); }

    /// The entry `files` with all that was read from disk, as text to put after the scenario's; may be empty.
    std::string appendix() const;

private:
    std::optional<Mesh> readKept(const Field &name) const;
    std::optional<Mesh> readFromDisk(const Field &name) const;

    bool kept_;
    Mapping files_;
    std::string folder_;
    std::vector<std::string> names_;  ///< asked for
    std::map<std::string, std::optional<Mesh>> fromDisk_;
};
}  // namespace narrows
