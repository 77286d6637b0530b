// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace narrows
{
/// CPU seconds that all threads of this process have used so far.
double processCpuSeconds();

/// Resident memory of this process now, in KiB; nothing where the system does not tell.
std::optional<double> residentKb();

/// The largest resident memory since the last `resetPeakResident()`, in KiB; nothing where the system does not tell.
std::optional<double> peakResidentKb();

/// Forgets the peak. Without effect where the system does not allow it: then the peak is that since the process began.
void resetPeakResident();

/// Address space that this process has reserved, in bytes; 0 where the system does not tell.
unsigned long addressSpaceBytes();
}  // namespace narrows
