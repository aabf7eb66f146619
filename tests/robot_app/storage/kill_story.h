// A store and its server, killed again and again while messages come: what is found on the server
// in the end.
#ifndef COPPICE_TESTS_ROBOT_APP_STORAGE_KILL_STORY_H_
#define COPPICE_TESTS_ROBOT_APP_STORAGE_KILL_STORY_H_

#include <cstdint>

#include "tests/robot_app/storage/local_postgres.h"

namespace coppice::robot::storage {

struct KillStory {
  int store_kills = 0;
  int server_kills = 0;
  std::int64_t accepted = 0;  ///< numbers that the spool had accepted
  std::int64_t lost = 0;      ///< of these, on the server: none
  std::int64_t twice = 0;     ///< numbers that are there more than once
};

/// Kills the store so often, at moments by chance, and the server so often, in turn; then lets both
/// finish. Throws std::runtime_error if they do not.
KillStory TellKillStory(LocalPostgres& postgres, int store_kills, int server_kills, unsigned seed);

}  // namespace coppice::robot::storage

#endif  // COPPICE_TESTS_ROBOT_APP_STORAGE_KILL_STORY_H_
