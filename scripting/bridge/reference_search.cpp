// What the reference says about one name.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/scripting/reference.h>

#include "bind/fields.h"
#include "bridge/conf.h"
#include "bridge/field_table.h"
#include "bridge/other_words.h"
#include "bridge/reference_parts.h"
#include "data/nearest.h"
#include "level/format.h"

namespace cairn::scripting {
namespace {

constexpr std::string_view kGlobal = "cairn.";

/// In lower case and without what an author may write or leave out: "World:step()" and "cairn.audio.play"
/// become "world:step" and "audio.play".
std::string plain_name(std::string_view name) {
    std::string plain;
    for (const char c : name.substr(0, name.find('(')))
        plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return plain.starts_with(kGlobal) ? plain.substr(kGlobal.size()) : plain;
}

/// "world:step", for a function.
std::string plain_name(const Function& function, const Module& module) {
    return plain_name(call_text(function, module));
}

/// A name of another framework in Cairn's way of writing: "love.graphics.newImage" becomes
/// "graphics.new_image".
std::string snake_name(std::string_view name) {
    if (constexpr std::string_view kLove = "love."; name.starts_with(kLove)) name.remove_prefix(kLove.size());
    std::string snake;
    for (const char c : name) {
        const bool is_capital = c >= 'A' && c <= 'Z';
        if (is_capital && !snake.empty() && snake.back() >= 'a' && snake.back() <= 'z') snake += '_';
        snake += c;
    }
    return plain_name(snake);
}

void write_summary(const Module& module, std::string& out) {
    out += std::string("## ") + module.name + "\n\n" + module.doc + "\n\n";
    for (const Function& function : module.functions) out += "    " + signature(function, module) + '\n';
}

/// A field as it is described in one or several tables.
struct FoundField {
    std::string table;  ///< in Markdown
    std::string places;
};

/// What is found under a name, and all names that there are.
struct Search {
    std::string wanted;
    std::vector<std::string> names = {};
    std::vector<std::string> field_names = {};
    std::string found = {};
    std::vector<FoundField> fields = {};

    bool is(const std::string& name) {
        names.push_back(name);
        return name == wanted;
    }
};

void search_parts(Search& search) {
    for (const Module* module : all_modules())
        if (search.is(plain_name(module->name))) write_summary(*module, search.found);
    if (search.is("callbacks")) write_callbacks(search.found);
    if (search.is("conf.lua")) write_conf(search.found);
}

void search_given(Search& search) {
    for (const Callback& callback : callbacks()) {
        if (search.is(callback.name))
            search.found += "\n### `" + signature(callback) + "`\n\nA callback: " + callback.doc + ".\n";
    }
    for (const Field* field : conf_fields()) {
        if (search.is(field->name))
            search.found +=
                std::string("\n### `") + field->name + "` in conf.lua\n" + field_table({&field, 1});
    }
}

/// Functions by their whole names, or also by their own alone.
void search_functions(Search& search, bool by_own_name) {
    for (const Module* module : all_modules()) {
        for (const Function& function : module->functions) {
            const bool is_it = search.is(plain_name(function, *module));
            if (is_it || (by_own_name && function.name == search.wanted))
                write_function(function, *module, search.found);
        }
    }
}

// ---- Fields

void search_fields(Search& search, const std::vector<const Field*>& fields, const std::string& place) {
    for (const Field* field : fields) {
        search.field_names.emplace_back(field->name);
        if (search.wanted != field->name) continue;
        const std::string table = field_table({&field, 1});
        const auto known = std::find_if(search.fields.begin(), search.fields.end(),
                                        [&](const FoundField& found) { return found.table == table; });
        if (known == search.fields.end()) {
            search.fields.push_back({table, place});
        } else {
            known->places += ", " + place;
        }
    }
}

/// Of the tables that functions take, and of levels.
void search_all_fields(Search& search) {
    for (const Module* module : all_modules()) {
        for (const Function& function : module->functions) {
            if (function.fields != nullptr)
                search_fields(search, all_fields(*function.fields), call_text(function, *module) + "{...}");
        }
    }
    search_fields(search, all_fields(kLevelFields), "levels");
    search_fields(search, all_fields(kCameraFields), "the camera of levels");
    search_fields(search, all_fields(kBoundsFields), "the bounds of levels");
    search_fields(search, all_fields(kSpawnFields), "spawns of levels");
    search_fields(search, all_fields(kDecorationFields), "decorations of levels");
    search_fields(search, all_fields(kLevelMaterialFields), "materials of levels");
    for (const PartSection& section : kPartSections)
        search_fields(search, all_fields(*section.own), std::string(section.list) + " of levels");
}

void write_fields(Search& search) {
    for (const FoundField& field : search.fields)
        search.found += "\n### `" + search.wanted + "` in " + field.places + '\n' + field.table;
}

// ---- What is like it

/// Those with the words of what is wanted among theirs: "world:add_wheel_joint" for "wheel". Not those that
/// are called just so.
std::string related_names(const std::string& to, const std::vector<std::string>& among) {
    constexpr int kMost = 12;
    const auto words = [](std::string name) {
        std::replace_if(
            name.begin(), name.end(), [](char c) { return c == '.' || c == ':'; }, '_');
        return '_' + name + '_';
    };
    const std::string wanted = words(to);
    std::vector<std::string> related;
    for (const std::string& name : among) {
        const std::string own = words(name.substr(name.find_first_of(".:") + 1));  // all of it without one
        const bool is_known = std::find(related.begin(), related.end(), name) != related.end();
        if (own != wanted && own.find(wanted) != std::string::npos && !is_known) related.push_back(name);
    }
    std::string text;
    for (std::size_t i = 0; i < related.size() && i < kMost; ++i) text += (i > 0 ? ", " : "") + related[i];
    return text + (related.size() > kMost ? ", ..." : "");
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        words.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

/// What an author of another framework looks for: what Cairn calls it, and what it says of that.
std::string text_of(const OtherWord& other, std::string_view name) {
    std::string names;
    std::string text;
    for (const std::string& own : words_of(other.names)) {
        names += (names.empty() ? "`" : ", `") + own + '`';
        if (const auto found = reference_of(own)) text += '\n' + *found;
    }
    std::string head = "`" + std::string(name) + "` is ";
    head += names.empty() ? "not a name of Cairn's" : "in Cairn: " + names;
    if (!other.note.empty()) head += "; " + std::string(other.note);
    return head + ".\n" + text;
}

/// Fills in what is found under `search.wanted`; the name is as the author typed it.
bool search_all(Search& search, std::string_view name) {
    search_parts(search);
    const bool is_part = !search.found.empty();
    search_given(search);
    // "update" is also what cameras have of that name, "cairn.update" is the callback alone.
    const bool is_callback_alone = name.starts_with(kGlobal) && is_callback(search.wanted);
    search_functions(search, !is_part && !is_callback_alone);
    search_all_fields(search);
    if (!is_part && !is_callback_alone) write_fields(search);
    if (search.found.empty()) return false;
    if (is_part) return true;
    const OtherWord* other = other_word(search.wanted);
    std::string related;
    for (const std::string& own : words_of(other == nullptr ? "" : other->names))
        related += (related.empty() ? "" : ", ") + own;
    if (const std::string like_it = related_names(search.wanted, search.names); !like_it.empty())
        related += (related.empty() ? "" : ", ") + like_it;
    if (!related.empty()) search.found += "\nSee also " + related + ".\n";
    return true;
}

}  // namespace

engine::Result<std::string> reference_of(std::string_view name) {
    Search search{.wanted = plain_name(name)};
    const auto text = [](const Search& of) { return of.found.substr(of.found.find_first_not_of('\n')); };
    if (search_all(search, name)) return text(search);
    const std::string snake = snake_name(name);
    if (Search in_our_way{.wanted = snake}; snake != search.wanted && search_all(in_our_way, name))
        return text(in_our_way);
    for (const std::string& word : {snake, snake.substr(snake.find_last_of(".:") + 1), search.wanted}) {
        if (const OtherWord* other = other_word(word)) return text_of(*other, name);
    }
    std::vector<std::string> all = search.names;
    all.insert(all.end(), search.field_names.begin(), search.field_names.end());
    const std::string related = related_names(search.wanted, all);
    for (const Module* module : all_modules())
        for (const Function& function : module->functions) all.emplace_back(function.name);
    const std::string_view best = nearest(search.wanted, all);
    return engine::Error{"the reference has nothing that is called \"" + std::string(name) + '"' +
                         (best.empty() ? "" : "; did you mean \"" + std::string(best) + "\"?") +
                         (related.empty() ? "" : "; see also " + related)};
}

}  // namespace cairn::scripting
