// A process that is killed in the middle of what it does on the disk.
#ifndef COPPICE_TESTS_EDITOR_FILES_DYING_CALLS_H_
#define COPPICE_TESTS_EDITOR_FILES_DYING_CALLS_H_

namespace coppice {

/// From now on the calls of this process that change the disk (write, fsync, rename, remove,
/// unlink) are counted, twice each: before and after. At this count it dies as by SIGKILL, in the
/// middle of a write when half of the bytes are there. What the C library's own streams (FILE*)
/// write is not counted.
void DieAtDiskCall(int count);

}  // namespace coppice

#endif  // COPPICE_TESTS_EDITOR_FILES_DYING_CALLS_H_
