// SPDX-License-Identifier: BSD-3-Clause
// What the parts of ResultStore share; for nobody else.
#pragma once

#include <exception>
#include <memory>
#include <new>
#include <set>
#include <string>

#include <SQLiteCpp/SQLiteCpp.h>

#include "benchmark/Experiment.h"

#include "scenario/Scenario.h"

namespace narrows
{
/// \throws InputError about the file, always
[[noreturn]] void refuse(const std::string &path, const std::string &reason);

/// Foreign keys, and patience with others who write.
void setUp(SQLite::Database &database);

/// All tables of an empty database, and the marks by which it is known as ours.
void makeTables(SQLite::Database &database);

/// Opens a file that must be a sound database of ours.
/// \throws InputError if it is not
std::unique_ptr<SQLite::Database> openOurs(const std::string &path, int mode);

/// What `read` returns, for cells that another program, or damage, may have changed since we wrote them.
/// \throws InputError about the database's file for whatever `read` throws, memory aside
template <typename Read>
auto readFrom(const SQLite::Database &database, const Read &read)
{
    try
    {
        return read();
    }
    catch (const InputError &)
    {
        throw;
    }
    catch (const std::bad_alloc &)
    {
        throw;
    }
    catch (const std::exception &error)
    {
        refuse(database.getFilename(), std::string("holds what this program does not write: ") + error.what());
    }
}

/// The tables of hypotheses and canaries, where they are not there yet.
void addDeclarationTables(SQLite::Database &database);

void insertHypotheses(SQLite::Database &database, const Hypotheses &hypotheses);

/// \throws InputError naming a hypothesis that was declared otherwise when the database was begun
void requireSameHypotheses(const std::string &path, SQLite::Database &database, const Hypotheses &hypotheses);

/// What `write` returns, if there is room for what it writes.
/// \throws InputError about the database's file if there is not, or the file cannot be written any more
template <typename Write>
auto writeTo(const SQLite::Database &database, const Write &write)
{
    try
    {
        return write();
    }
    catch (const SQLite::Exception &error)
    {
        refuse(database.getFilename(), std::string("cannot be written: ") + error.what() +
                                           "; what it holds stays, and --resume goes on from there");
    }
}

/// The columns of the table `runs` that the database has.
std::set<std::string> runColumns(SQLite::Database &database);

/// What an older program began lacks the newest metrics and facts of the environment: their cells are NULL, not known,
/// in the rows that it wrote.
void addNewColumns(SQLite::Database &database);
}  // namespace narrows
