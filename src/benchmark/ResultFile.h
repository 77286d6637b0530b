// SPDX-License-Identifier: BSD-3-Clause
// What the parts of ResultStore share; for nobody else.
#pragma once

#include <memory>
#include <set>
#include <string>

#include <SQLiteCpp/SQLiteCpp.h>

namespace narrows
{
/// \throws InputError about the file, always
[[noreturn]] void refuse(const std::string &path, const std::string &reason);

/// Opens a file that must be a sound database of ours.
/// \throws InputError if it is not
std::unique_ptr<SQLite::Database> openOurs(const std::string &path, int mode);

/// The columns of the table `runs` that the database has.
std::set<std::string> runColumns(SQLite::Database &database);

/// What an older program began lacks the newest metrics: their cells are NULL, not measured, in the rows that it wrote.
void addNewMetrics(SQLite::Database &database);
}  // namespace narrows
