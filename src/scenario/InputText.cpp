// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/InputText.h"

#include <array>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <boost/locale/utf.hpp>

#include "scenario/Scenario.h"

namespace narrows
{
namespace
{
constexpr std::size_t mostBytes = std::size_t{16} << 20;

[[noreturn]] void refuse(const std::string &file, int line, const std::string &reason)
{
    throw InputError({{file, line, "", reason}});
}

bool isText(boost::locale::utf::code_point c)
{
    return c >= 0x20 ? c != 0x7f : c == '\t' || c == '\n' || c == '\r';
}
}  // namespace

std::string readInputText(const std::string &path)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status))
        refuse(path, 0, "there is no such file");
    if (std::filesystem::is_directory(status))
        refuse(path, 0, "is a directory, not a file");
    std::ifstream stream(path, std::ios::binary);
    std::string text;
    std::array<char, 65536> chunk;
    while (stream && text.size() <= mostBytes)
    {
        stream.read(chunk.data(), chunk.size());
        text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (!stream && !stream.eof())
        refuse(path, 0, "cannot be read");
    if (text.size() > mostBytes)
        refuse(path, 0, fmt::format("is larger than {} MiB", mostBytes >> 20));
    return text;
}

void checkInputText(const std::string &text, const std::string &file)
{
    using Utf8 = boost::locale::utf::utf_traits<char>;
    int line = 1;
    bool blank = true;
    for (auto place = text.begin(); place != text.end();)
    {
        const boost::locale::utf::code_point c = Utf8::decode(place, text.end());
        if (c == boost::locale::utf::illegal || c == boost::locale::utf::incomplete)
            refuse(file, line, "is not a text file in UTF-8");
        if (!isText(c))
            refuse(file, line, fmt::format("is not a text file: it has the control character {:#04x}", c));
        line += c == '\n' ? 1 : 0;
        blank = blank && (c == '\n' || c == '\r' || c == ' ' || c == '\t');
    }
    if (blank)
        refuse(file, 0, "is empty");
}
}  // namespace narrows
