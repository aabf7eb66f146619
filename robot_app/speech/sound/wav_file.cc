#include "robot_app/speech/sound/wav_file.h"

#include <sndfile.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "bt_core/base/diagnostic.h"
#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::robot::speech {
namespace {

// Bytes in memory as the file of libsndfile.
struct Memory {
  std::string bytes;
  sf_count_t at = 0;

  sf_count_t size() const { return static_cast<sf_count_t>(bytes.size()); }
};

Memory& Of(void* user) { return *static_cast<Memory*>(user); }

sf_count_t Seek(sf_count_t offset, int whence, void* user) {
  Memory& memory = Of(user);
  const sf_count_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? memory.at : memory.size();
  memory.at = std::clamp<sf_count_t>(from + offset, 0, memory.size());
  return memory.at;
}

sf_count_t Read(void* target, sf_count_t count, void* user) {
  Memory& memory = Of(user);
  const sf_count_t taken = std::clamp<sf_count_t>(count, 0, memory.size() - memory.at);
  std::memcpy(target, memory.bytes.data() + memory.at, static_cast<std::size_t>(taken));
  memory.at += taken;
  return taken;
}

sf_count_t Write(const void* source, sf_count_t count, void* user) {
  Memory& memory = Of(user);
  const auto end = static_cast<std::size_t>(memory.at + count);
  if (memory.bytes.size() < end) memory.bytes.resize(end);
  std::memcpy(memory.bytes.data() + memory.at, source, static_cast<std::size_t>(count));
  memory.at += count;
  return count;
}

sf_count_t Length(void* user) { return Of(user).size(); }
sf_count_t Tell(void* user) { return Of(user).at; }

SNDFILE* Open(Memory& memory, int mode, SF_INFO& info) {
  static SF_VIRTUAL_IO io = {&Length, &Seek, &Read, &Write, &Tell};
  return sf_open_virtual(&io, mode, &info, &memory);
}

Outcome CheckForm(const SF_INFO& info) {
  const int type = info.format & SF_FORMAT_TYPEMASK;
  if (type != SF_FORMAT_WAV && type != SF_FORMAT_WAVEX) return Problem{"expected a WAV file"};
  if (info.samplerate < 4000 || info.samplerate > 192000) {
    return Problem{"expected a rate of 4 to 192 kHz"};
  }
  if (info.channels < 1 || info.channels > 16) return Problem{"expected 1 to 16 channels"};
  if (static_cast<double>(info.frames) > kLongestSound * info.samplerate) {
    return Problem{"expected at most " + std::to_string(static_cast<int>(kLongestSound)) + " s"};
  }
  return {};
}

// libsndfile would read many other kinds of files; nobody needs them here but who looks for
// mistakes.
bool LooksLikeWav(const std::string& bytes) {
  return bytes.compare(0, 4, "RIFF") == 0 && bytes.size() > 12 && bytes.compare(8, 4, "WAVE") == 0;
}

// The first channel, as long as there is something: what the file says of its length may be wrong.
std::vector<std::int16_t> FirstChannel(SNDFILE* file, const SF_INFO& info) {
  constexpr sf_count_t kBlock = 4096;  // frames
  const auto channels = static_cast<std::size_t>(info.channels);
  const auto most = static_cast<std::size_t>(kLongestSound * info.samplerate);
  std::vector<std::int16_t> block(kBlock * channels), samples;
  while (samples.size() < most) {
    const sf_count_t frames = sf_readf_short(file, block.data(), kBlock);
    if (frames <= 0) break;
    for (sf_count_t i = 0; i < frames; ++i) {
      samples.push_back(block[static_cast<std::size_t>(i) * channels]);
    }
  }
  return samples;
}

}  // namespace

Expected<Sound> ParseWav(const std::string& bytes) {
  if (!LooksLikeWav(bytes)) return Problem{"expected a WAV file"};
  Memory memory{bytes};
  SF_INFO info{};
  SNDFILE* const file = Open(memory, SFM_READ, info);
  if (file == nullptr) return Problem{"expected a WAV file"};
  const Outcome form = CheckForm(info);
  if (!form) {
    sf_close(file);
    return Problem{form.problem()};
  }
  Sound sound{info.samplerate, FirstChannel(file, info)};
  sf_close(file);
  return sound;
}

Expected<Sound> ReadWav(const std::string& path) {
  std::error_code error;  // told by who reads it
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return Problem{path + ": expected a WAV file"};  // who has a pipe open may never write into it
  }
  Diagnostics diagnostics;
  const auto bytes = ReadFile(path, diagnostics);
  if (!bytes) return Problem{ToString(diagnostics.all().front())};
  auto sound = ParseWav(*bytes);
  return sound ? std::move(sound) : Problem{path + ": " + sound.problem()};
}

std::string WavOf(const Sound& sound) {
  Memory memory;
  SF_INFO info{};
  info.samplerate = sound.rate;
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
  SNDFILE* const file = Open(memory, SFM_WRITE, info);
  if (file == nullptr) return {};
  sf_writef_short(file, sound.samples.data(), static_cast<sf_count_t>(sound.samples.size()));
  sf_close(file);
  return std::move(memory.bytes);
}

Outcome WriteWav(const std::string& path, const Sound& sound) {
  Diagnostics diagnostics;
  if (WriteFile(path, WavOf(sound), diagnostics)) return {};
  return Problem{ToString(diagnostics.all().front())};
}

}  // namespace coppice::robot::speech
