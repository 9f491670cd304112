// Finds how many characters fit by halving: a text never gets narrower by a character more.
#include "ui/shortened_text.h"

#include <string_view>
#include <vector>

#include <cairn/engine/utf8.h>

namespace cairn::engine {
namespace {

constexpr const char* kEllipsis = "\u2026";

/// Where each character of a text begins, and its end.
std::vector<std::size_t> boundaries(std::string_view text) {
    std::vector<std::size_t> places = {0};
    const std::size_t size = text.size();
    while (!text.empty()) {
        take_character(text);
        places.push_back(size - text.size());
    }
    return places;
}

}  // namespace

std::string shortened_text(const Renderer& renderer, FontId font, const std::string& text, float width,
                           KeptEnd kept) {
    const auto fits = [&](const std::string& candidate) {
        return renderer.measure_text(font, candidate).x <= width;
    };
    if (fits(text)) return text;
    const std::vector<std::size_t> places = boundaries(text);
    const auto with = [&](std::size_t characters) {
        if (kept == KeptEnd::Front) return text.substr(0, places[characters]) + kEllipsis;
        return kEllipsis + text.substr(places[places.size() - 1 - characters]);
    };
    std::size_t fitting = 0;
    std::size_t too_many = places.size() - 1;
    while (fitting + 1 < too_many) {
        const std::size_t middle = (fitting + too_many) / 2;
        (fits(with(middle)) ? fitting : too_many) = middle;
    }
    std::string shortened = with(fitting);
    return fits(shortened) ? shortened : std::string();
}

}  // namespace cairn::engine
