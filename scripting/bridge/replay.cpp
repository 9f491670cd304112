// The format, by lines: "cairn-replay 1", then "game NAME", "seed N", "size W H", "frames N", perhaps "hash
// HEX", then "events" and one line per event, "FRAME EVENT", the event as the engine writes it. Blank lines
// and # comments are allowed.
#include "bridge/replay.h"

#include <charconv>
#include <cstdio>

namespace cairn::scripting {
namespace {

constexpr std::string_view kFirstLine = "cairn-replay 1";

std::string_view take_word(std::string_view& line) {
    const std::size_t end = std::min(line.find(' '), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    return word;
}

template <class T>
std::optional<T> to_number(std::string_view word, int base = 10) {
    T number{};
    const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), number, base);
    if (status != std::errc{} || end != word.data() + word.size() || word.empty()) return std::nullopt;
    return number;
}

class ReplayParser {
  public:
    ReplayParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    engine::Result<Replay> parse() {
        if (!next_line() || line_ != kFirstLine) {
            return fail("this is no recording that this version can play: the first line is \"" +
                        std::string(line_.substr(0, 40)) + "\", expected \"" + std::string(kFirstLine) + '"');
        }
        while (true) {
            if (!next_line()) return fail("the file ends before the line \"events\"");
            if (line_ == "events") break;
            if (auto error = header_line()) return *error;
        }
        for (const auto& [name, is_given] :
             {std::pair("game", has_game_), std::pair("seed", has_seed_), std::pair("size", has_size_),
              std::pair("frames", has_frames_)}) {
            if (!is_given)
                return fail(std::string("the line \"") + name + " ...\" is missing before \"events\"");
        }
        while (next_line()) {
            if (auto error = event_line()) return *error;
        }
        return std::move(replay_);
    }

  private:
    /// Skips blank lines and comments.
    bool next_line() {
        while (position_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', position_), text_.size());
            line_ = text_.substr(position_, end - position_);
            if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
            position_ = end + 1;
            ++number_;
            if (!line_.empty() && line_.front() != '#') return true;
        }
        line_ = {};
        return false;
    }

    engine::Error fail(const std::string& what) const {
        return {name_ + ':' + std::to_string(std::max(number_, 1)) + ": " + what};
    }

    std::optional<engine::Error> header_line() {
        std::string_view rest = line_;
        const std::string_view name = take_word(rest);
        if (name == "game") {
            replay_.game = rest;
            has_game_ = true;
            return rest.empty() ? std::optional(fail("\"game\" needs the name of the game")) : std::nullopt;
        }
        if (name == "size") {
            const auto width = to_number<int>(take_word(rest));
            const auto height = to_number<int>(rest);
            if (!width || !height || *width < 1 || *height < 1)
                return fail("\"size\" needs a width and a height in pixels");
            replay_.size = {*width, *height};
            has_size_ = true;
            return std::nullopt;
        }
        const bool is_hash = name == "hash";
        if (name != "seed" && name != "frames" && !is_hash) {
            return fail("unknown line \"" + std::string(name) +
                        "\"; expected game, seed, size, frames, hash or events");
        }
        const auto number = to_number<std::uint64_t>(rest, is_hash ? 16 : 10);
        if (!number || (is_hash && rest.size() != 16)) {
            return fail('"' + std::string(name) + "\" needs " +
                        (is_hash ? "16 hexadecimal digits" : "a whole number, at least 0") + ", found \"" +
                        std::string(rest) + '"');
        }
        if (name == "seed") replay_.seed = *number, has_seed_ = true;
        if (name == "frames") replay_.frames = *number, has_frames_ = true;
        if (is_hash) replay_.hash = *number;
        return std::nullopt;
    }

    std::optional<engine::Error> event_line() {
        std::string_view rest = line_;
        const std::string_view word = take_word(rest);
        const auto frame = to_number<std::uint64_t>(word);
        if (!frame)
            return fail("an event begins with the number of its frame, found \"" + std::string(word) + '"');
        if (*frame < 1 || *frame > replay_.frames) {
            return fail("frame " + std::string(word) + " is not in 1 to " + std::to_string(replay_.frames) +
                        ", the frames of this recording");
        }
        if (!replay_.events.empty() && *frame < replay_.events.back().frame) {
            return fail("frame " + std::string(word) + " comes after frame " +
                        std::to_string(replay_.events.back().frame) + "; events must be in order");
        }
        const auto event = engine::input_event_from_text(rest);
        if (!event) return fail(event.error().message);
        replay_.events.push_back({*frame, *event});
        return std::nullopt;
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t position_ = 0;
    int number_ = 0;
    std::string_view line_;
    Replay replay_;
    bool has_game_ = false;
    bool has_seed_ = false;
    bool has_size_ = false;
    bool has_frames_ = false;
};

}  // namespace

std::string hash_text(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

std::string to_text(const Replay& replay) {
    std::string text(kFirstLine);
    text += "\ngame " + replay.game + "\nseed " + std::to_string(replay.seed) + "\nsize " +
            std::to_string(replay.size.width) + ' ' + std::to_string(replay.size.height) + "\nframes " +
            std::to_string(replay.frames) + '\n';
    if (replay.hash) text += "hash " + hash_text(*replay.hash) + '\n';
    text += "events\n";
    for (const ReplayEvent& event : replay.events) {
        text += std::to_string(event.frame) + ' ' + engine::to_text(event.event) + '\n';
    }
    return text;
}

engine::Result<Replay> parse_replay(std::string_view text, const std::string& name) {
    return ReplayParser(text, name).parse();
}

}  // namespace cairn::scripting
