// cairn.text and the methods of Text. Invariant: the parts of a Text are one string, so that lines are broken
// as if it had one color.
#include <vector>

#include "bind/fields.h"
#include "bind/graphics_objects.h"
#include "bind/modules.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

/// User value 1 is the font, if one was given.
struct TextObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Text;
    std::string text;
    std::vector<engine::TextSpan> spans;
    engine::FontId font;
    engine::TextAlign align;
    float width;
    float line_spacing;
    int shown = -1;
};

}  // namespace

template <>
struct Argument<TextObject*> {
    static constexpr std::string_view kType = "Text";
    static TextObject* get(lua_State* L, int index) {
        auto* text = object_at<TextObject>(L, index);
        if (text == nullptr) argument_error(L, index, "a Text");
        return text;
    }
};

namespace {

constexpr Field kWidth =
    at_least(number_field("width", 0, "0", "px; lines are broken to be no wider; 0: only at line ends"), 0);
constexpr Field kAlign{"align", FieldType::String, "left", "\"left\", \"center\" or \"right\""};
constexpr Field kLineSpacing = above(number_field("line_spacing", 1, "1", "times the font's height"), 0, 100);
constexpr const Field* kOwn[] = {&kWidth, &kAlign, &kLineSpacing};
constexpr FieldSet kTextFields{kOwn};

int count_characters(std::string_view text) {
    int count = 0;
    for (const char c : text) count += (static_cast<unsigned char>(c) & 0xc0) != 0x80 ? 1 : 0;
    return count;
}

/// Whole, with whatever bytes it has.
std::string_view string_at(lua_State* L, int index) {
    std::size_t length = 0;
    const char* text = lua_tolstring(L, index, &length);
    return {text, length};
}

/// The part { text, r, g, b, a? } on top of the stack.
void add_colored(lua_State* L, TextObject& object, lua_Integer number) {
    const auto fail = [&] {
        call_error(L, "parts[" + std::to_string(number) +
                          "] must be a string, or { string, r, g, b, a? } with numbers");
    };
    engine::Color color;
    float* const channels[] = {&color.r, &color.g, &color.b, &color.a};
    for (int i = 0; i < 4; ++i) {
        const int type = lua_rawgeti(L, -1, i + 2);
        if (type == LUA_TNUMBER)
            *channels[i] = static_cast<float>(lua_tonumber(L, -1));
        else if (i < 3 || type != LUA_TNIL)
            fail();
        lua_pop(L, 1);
    }
    if (lua_rawgeti(L, -1, 1) != LUA_TSTRING) fail();
    object.spans.push_back({count_characters(object.text), color});
    object.text += string_at(L, -1);
    lua_pop(L, 1);
}

/// Reads a string, or a list of parts.
void read_parts(lua_State* L, int index, TextObject& object) {
    object.text.clear();
    object.spans.clear();
    if (lua_type(L, index) == LUA_TSTRING) {
        object.text = string_at(L, index);
        return;
    }
    if (!lua_istable(L, index)) argument_error(L, index, "a string, or a list of parts");
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, index));
    for (lua_Integer i = 1; i <= count; ++i) {
        const int type = lua_rawgeti(L, index, i);
        if (type == LUA_TTABLE) {
            add_colored(L, object, i);
        } else if (type == LUA_TSTRING) {
            object.spans.push_back({count_characters(object.text), {}});
            object.text += string_at(L, -1);
        } else {
            call_error(L, "parts[" + std::to_string(i) + "] is " + describe_value(L, -1) +
                              "; expected a string, or { string, r, g, b, a? }");
        }
        lua_pop(L, 1);
    }
}

engine::FontId default_or(lua_State* L, std::optional<FontObject*> font) {
    return font ? (*font)->font : default_font(L);
}

Pushed new_text(lua_State* L, AnyArgument parts, std::optional<TableArgument> fields,
                std::optional<FontObject*> font) {
    if (!fields) lua_newtable(L);
    const FieldReader reader(L, fields ? fields->index : -1, kTextFields);
    const std::string_view name = reader.text(kAlign);
    engine::TextAlign align = engine::TextAlign::Left;
    if (name == "center")
        align = engine::TextAlign::Center;
    else if (name == "right")
        align = engine::TextAlign::Right;
    else if (name != "left")
        reader.fail(kAlign, "must be \"left\", \"center\" or \"right\"");
    const float width = reader.real(kWidth);
    const float line_spacing = reader.real(kLineSpacing);
    auto& made = new_object<TextObject>(L, 0, std::string(), std::vector<engine::TextSpan>(),
                                        default_or(L, font), align, width, line_spacing);
    read_parts(L, parts.index, made);
    return {1};
}

Pushed wrap(lua_State* L, std::string_view text, NotNegative width, std::optional<FontObject*> font) {
    const std::vector<std::string> lines =
        context_of(L).services.renderer.wrap_text(default_or(L, font), text, width);
    lua_createtable(L, static_cast<int>(lines.size()), 0);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        lua_pushlstring(L, lines[i].data(), lines[i].size());
        lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
    return {1};
}

void set_text(lua_State* L, TextObject* self, AnyArgument parts) {
    TextObject fresh = *self;
    read_parts(L, parts.index, fresh);  // may fail; then the old text stays
    *self = std::move(fresh);
}
std::tuple<float, float> size(lua_State* L, TextObject* self) {
    const engine::Vec2 extent =
        context_of(L).services.renderer.measure_text(self->font, self->text, self->width, self->line_spacing);
    return {extent.x, extent.y};
}
std::int64_t length(TextObject* self) {
    return count_characters(self->text);
}
void set_shown(TextObject* self, std::optional<Count> count) {
    self->shown = count ? static_cast<int>(std::min<std::int64_t>(*count, 1 << 30)) : -1;
}

void draw(lua_State* L, TextObject* self, float x, float y) {
    const Context& context = drawing_context(L);
    engine::Renderer& renderer = context.services.renderer;
    engine::TextDraw text{.position = {x, y},
                          .color = context.draw.color,
                          .align = self->align,
                          .wrap_width = self->width,
                          .line_spacing = self->line_spacing,
                          .spans = self->spans,
                          .shown = self->shown};
    if (!renderer.is_y_up()) return renderer.draw_text(self->font, self->text, text);
    // Letters keep their size in pixels under a camera.
    text.position = renderer.transform().apply(text.position);
    check_or_raise(L, renderer.push_transform());
    renderer.reset_transform();
    renderer.draw_text(self->font, self->text, text);
    check_or_raise(L, renderer.pop_transform());
}

constexpr std::array<std::string_view, 1> kReturnsText = {"Text"};
constexpr std::array<std::string_view, 1> kReturnsLines = {"string[]"};

constexpr Function kModuleFunctions[] = {
    function_pushing<&new_text>(
        "new", "parts, fields = {}, font = nil", "text", kReturnsText,
        "Makes a text of a string, or of parts in colors of their own: `cairn.text.new({ \"Press \", "
        "{ \"A\", 1, 0.8, 0.3 }, \" to jump\" }, { width = 300 })`. Without a font it has the "
        "default one.",
        &kTextFields),
    function_pushing<&wrap>("wrap", "text, width [px], font = nil", "lines", kReturnsLines,
                            "The lines of a text that is broken to be no wider."),
};
constexpr Function kMethods[] = {
    function<&draw>("draw", "x, y", "",
                    "(x, y) is the top, at the left, in the middle or at the right by its alignment; with a "
                    "width, of the "
                    "left end of its box. It is tinted by the color that is set; only in `cairn.draw`."),
    function<&size>("size", "", "width [px], height [px]", ""),
    function<&length>("length", "", "characters", ""),
    function<&set_shown>(
        "set_shown", "characters = nil", "",
        "Only so many are drawn, where they will stand when all are: for text that is typed before the "
        "player's eyes. Nil: all."),
    function<&set_text>("set_text", "parts", "", "Another string, or other parts."),
};

}  // namespace

int finalize_text(lua_State* L) {
    object_at<TextObject>(L, 1)->~TextObject();
    return 0;
}

const Module kTextModule = {"cairn.text",
                            "Texts of several colors and lines. For a line of one color there is "
                            "`cairn.graphics.print`.",
                            kModuleFunctions};
const Module kTextMethods = {"Text", "A text that is broken into lines and colored.", kMethods, true};

}  // namespace cairn::scripting
