// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <yaml-cpp/yaml.h>

namespace narrows
{
/// The one YAML document that a text is.
/// \param file what messages call the text
/// \throws InputError if the text is not YAML, is nested too deeply or goes on after its first document.
YAML::Node parseYaml(const std::string &text, const std::string &file);
}  // namespace narrows
