#include "robot_app/speech/mouth/synthesizer.h"

#include <espeak-ng/speak_lib.h>

#include <mutex>
#include <sstream>
#include <stdexcept>

namespace coppice::robot::speech {
namespace {

std::mutex g_espeak;  // guards all of espeak-ng
int g_rate = 0;       // 0: not started yet

// The byte at which each character of a text in UTF-8 begins, and its end.
std::vector<std::size_t> CharacterBegins(const std::string& text) {
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) begins.push_back(i);
  }
  begins.push_back(text.size());
  return begins;
}

struct Synthesis {
  Speech speech;
  std::vector<std::size_t> begins;

  void Add(const espeak_EVENT& event) {
    if (event.type != espeakEVENT_WORD || event.text_position < 1) return;
    const auto first = static_cast<std::size_t>(event.text_position) - 1;
    const std::size_t last = first + static_cast<std::size_t>(std::max(event.length, 0));
    if (last >= begins.size()) return;
    speech.words.push_back(
        {event.audio_position / 1000.0, begins[first], begins[last] - begins[first]});
  }
};

// Called by espeak-ng with a piece of the sound; 0: go on.
int OnSamples(short* samples, int count, espeak_EVENT* events) {
  auto& synthesis = *static_cast<Synthesis*>(events->user_data);
  if (samples != nullptr && count > 0) {
    auto& all = synthesis.speech.sound.samples;
    all.insert(all.end(), samples, samples + count);
  }
  for (; events->type != espeakEVENT_LIST_TERMINATED; ++events) synthesis.Add(*events);
  return 0;
}

Outcome SetVoice(const std::string& name) {
  if (espeak_SetVoiceByName(name.c_str()) == EE_OK) return {};
  return Problem{"espeak-ng has no voice \"" + name + "\" (`espeak-ng --voices`)"};
}

}  // namespace

Synthesizer::Synthesizer() {
  const std::lock_guard<std::mutex> lock(g_espeak);
  if (g_rate > 0) return;
  const int rate =
      espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, 0, nullptr, espeakINITIALIZE_DONT_EXIT);
  if (rate <= 0) throw std::runtime_error("espeak-ng cannot be started: is espeak-ng-data there?");
  g_rate = rate;
  espeak_SetSynthCallback(&OnSamples);
}

Expected<Speech> Synthesizer::Speak(const std::string& text, const Voice& voice) const {
  const std::lock_guard<std::mutex> lock(g_espeak);
  if (Outcome set = SetVoice(voice.name); !set) return Problem{set.problem()};
  espeak_SetParameter(espeakRATE, voice.words_per_minute, 0);
  Synthesis synthesis;
  synthesis.begins = CharacterBegins(text);
  synthesis.speech.sound.rate = g_rate;
  const auto done = espeak_Synth(text.c_str(), text.size() + 1, 0, POS_CHARACTER, 0,
                                 espeakCHARS_UTF8, nullptr, &synthesis);
  if (done != EE_OK) return Problem{"espeak-ng cannot speak this"};
  return std::move(synthesis.speech);
}

std::vector<std::string> Synthesizer::Phonemes(const std::string& word,
                                               const std::string& voice) const {
  const std::lock_guard<std::mutex> lock(g_espeak);
  std::vector<std::string> phonemes;
  if (!SetVoice(voice)) return phonemes;
  constexpr int kIpa = 2;
  constexpr int kSeparator = ' ' << 8;
  const void* rest = word.c_str();
  while (rest != nullptr) {
    const char* said = espeak_TextToPhonemes(&rest, espeakCHARS_UTF8, kIpa | kSeparator);
    if (said == nullptr) break;
    std::istringstream stream(said);
    for (std::string phoneme; stream >> phoneme;) phonemes.push_back(phoneme);
  }
  return phonemes;
}

}  // namespace coppice::robot::speech
