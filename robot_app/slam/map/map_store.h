// A map on the disk as it grows: what each update has changed is written at once, all or nothing,
// so that a program that is killed at any moment goes on with the map as it was after its last
// update. And the long-term memory: what key frames saw is read again when it is asked for, so that
// the robot's memory holds only what it works with.
//
//   auto store = MapStore::Open("maps/memory.db");
//   SlamMap map = *(*store)->Load();                 // without what the key frames saw
//   (*store)->Keep(names, graph, key_frames);        // after each update
//   (*store)->Read(17);                              // what key frame 17 saw
//
// An SQLite database of packed parts (map_bytes.h): the sessions, the poses and the links, some
// hundred to a part, and each key frame. Only parts that have changed are written. A power failure
// may lose the last seconds, and nothing before.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_MAP_STORE_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_MAP_STORE_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/slam/map/slam_map.h"

namespace SQLite {
class Database;
}

namespace coppice::robot::slam {

/// Not thread-safe. One program at a time has a file.
class MapStore {
 public:
  /// Opens a file or makes it; "": one that nobody sees and that vanishes with the program. One
  /// that is damaged is put aside (.damaged) and made anew.
  static Expected<std::unique_ptr<MapStore>> Open(const std::string& file);
  ~MapStore();

  /// All but what the key frames saw: those are null. A problem: it is damaged.
  Expected<SlamMap> Load();

  /// Writes what is not yet in it. Key frames that are null were kept before.
  Outcome Keep(const std::vector<SessionName>& names, const SessionGraph& graph,
               const std::vector<std::shared_ptr<const KeyFrame>>& key_frames);

  /// Writes a key frame anew that is in it already.
  Outcome Replace(std::uint32_t key_frame, const KeyFrame& with);

  /// Forgets all that is in it.
  Outcome Clear();

  /// What a key frame saw, and the same as it is kept (map_bytes.h).
  Expected<std::shared_ptr<const KeyFrame>> Read(std::uint32_t key_frame);
  Expected<std::string> ReadPacked(std::uint32_t key_frame);

  /// Of the first so many.
  std::size_t key_frames() const { return key_frames_; }

  /// A number of the caller's that is kept with the map; 0 in a new one: the version that was saved
  /// last. What cannot be written now, on a full disk for example, is written by the next Keep().
  int version() const { return version_; }
  Outcome SetVersion(int version);

 private:
  explicit MapStore(std::unique_ptr<SQLite::Database> database, std::string file);
  void KeepAll(const std::vector<SessionName>& names, const SessionGraph& graph,
               const std::vector<std::shared_ptr<const KeyFrame>>& key_frames);
  void PutKeyFrameOf(std::size_t number, const KeyFrame& key_frame);
  static Expected<std::unique_ptr<MapStore>> OpenWhole(const std::string& file);
  std::size_t Count(int kind);
  template <typename Take>
  bool ReadAll(int kind, std::size_t least_size, Take take);
  bool ReadMap(SlamMap& map);
  void Put(int kind, std::size_t number, const std::string& packed);
  std::string Get(int kind, std::size_t number);
  Problem ProblemOf(const std::exception& error) const;

  std::unique_ptr<SQLite::Database> database_;
  const std::string file_;
  int version_ = 0;
  bool is_version_kept_ = true;
  // What is in it.
  std::size_t key_frames_ = 0;
  std::size_t links_ = 0;
  std::vector<Pose3> poses_;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_MAP_STORE_H_
