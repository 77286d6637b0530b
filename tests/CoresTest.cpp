// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Cores.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace narrows
{
namespace
{
using testing::ElementsAre;
using testing::IsEmpty;

TEST(Cores, ReadsAndWritesListsOfCpus)
{
    EXPECT_THAT(cpuListFromText("0"), ElementsAre(0));
    EXPECT_THAT(cpuListFromText("0-2,8,10-11\n"), ElementsAre(0, 1, 2, 8, 10, 11));
    for (const char *text : {"", "x", "-1", "3-1", "0-99999999"})
        EXPECT_THAT(cpuListFromText(text), IsEmpty()) << text;
    EXPECT_EQ(toText({0, 1, 2, 8, 10, 11}), "0-2,8,10-11");
    EXPECT_EQ(toText({}), "");
}

TEST(Cores, GroupsTheCpusThatItMayUseByPhysicalCore)
{
    const std::string root = testing::TempDir() + "cores" + std::to_string(getpid());
    for (int cpu = 0; cpu < 1024; ++cpu)  // pairs: 0 with 1, 2 with 3, ...
    {
        const std::string folder = root + "/cpu" + std::to_string(cpu) + "/topology";
        std::filesystem::create_directories(folder);
        std::ofstream(folder + (cpu % 4 < 2 ? "/core_cpus_list" : "/thread_siblings_list"))
            << cpu / 2 * 2 << "-" << cpu / 2 * 2 + 1 << "\n";
    }
    std::size_t cpus = 0;
    for (const CpuList &core : usablePhysicalCores(root))
    {
        ASSERT_FALSE(core.empty());
        cpus += core.size();
        for (const int cpu : core)
            EXPECT_EQ(cpu / 2, core.front() / 2);
    }
    std::filesystem::remove_all(root);
    // Where nothing is told, every CPU is a core.
    const std::vector<CpuList> untold = usablePhysicalCores(root);
    EXPECT_EQ(untold.size(), cpus);
}

TEST(Cores, AreSharedByNoTwoSlotsUnlessThereAreTooFew)
{
    const std::vector<CpuList> cores{{0, 4}, {1, 5}, {2, 6}};
    EXPECT_THAT(sharesOf(cores, 3), ElementsAre(CpuList{0, 4}, CpuList{1, 5}, CpuList{2, 6}));
    EXPECT_THAT(sharesOf(cores, 2), ElementsAre(CpuList{0, 2, 4, 6}, CpuList{1, 5}));
    EXPECT_THAT(sharesOf(cores, 4), ElementsAre(CpuList{0, 4}, CpuList{1, 5}, CpuList{2, 6}, CpuList{0, 4}));
    EXPECT_THAT(sharesOf({}, 2), ElementsAre(IsEmpty(), IsEmpty()));
}
}  // namespace
}  // namespace narrows
