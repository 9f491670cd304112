// The methods of Recording. States count from 1, as all in Lua does.
#include "bind/recording.h"

#include <cairn/physics/recording.h>

#include "bind/modules.h"
#include "bind/snapshot.h"

namespace cairn::scripting {
namespace {

struct RecordingObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Recording;
    physics::Recording recording;
};

constexpr Field kWhole = within(
    integer_field("states_between_whole_ones", 60, "60",
                  "every so many states one is kept whole: seeking applies at most so many differences"),
    1, 10'000);
constexpr const Field* kOwn[] = {&kWhole};

std::span<const std::byte> as_bytes(std::string_view text) {
    return std::as_bytes(std::span(text));
}

Pushed push_bytes(lua_State* L, const physics::Snapshot& bytes) {
    lua_pushlstring(L, reinterpret_cast<const char*>(bytes.bytes().data()), bytes.size());
    return {1};
}

}  // namespace

const FieldSet kRecordingFields{kOwn};

template <>
struct Argument<RecordingObject*> {
    static constexpr std::string_view kType = "Recording";
    static RecordingObject* get(lua_State* L, int index) {
        auto* recording = object_at<RecordingObject>(L, index);
        if (recording == nullptr) argument_error(L, index, "a Recording");
        return recording;
    }
};

Pushed new_recording(lua_State* L, std::optional<TableArgument> fields) {
    if (!fields) lua_newtable(L);
    const FieldReader reader(L, fields ? fields->index : -1, kRecordingFields);
    new_object<RecordingObject>(L, 0, physics::Recording(static_cast<int>(reader.integer(kWhole))));
    return {1};
}

Pushed make_delta(lua_State* L, std::string_view base, std::string_view target) {
    physics::Snapshot delta;
    check_or_raise(L, physics::make_delta(as_bytes(base), as_bytes(target), delta));
    return push_bytes(L, delta);
}

Pushed apply_delta(lua_State* L, std::string_view base, std::string_view delta) {
    physics::Snapshot target;
    check_or_raise(L, physics::apply_delta(as_bytes(base), as_bytes(delta), target));
    return push_bytes(L, target);
}

namespace {

physics::Result<void> record(lua_State* L, RecordingObject* self, WorldRef world) {
    const std::size_t bytes = self->recording.byte_count();
    const physics::Result<void> done = self->recording.record(world.world);
    if (done) charge_native_memory(L, self->recording.byte_count() - bytes);
    return done;
}

std::int64_t size(RecordingObject* self) {
    return self->recording.size();
}
std::int64_t byte_count(RecordingObject* self) {
    return static_cast<std::int64_t>(self->recording.byte_count());
}

/// As the physics counts them; or an error is raised.
int to_state(lua_State* L, const RecordingObject& self, std::int64_t index) {
    if (index < 1 || index > self.recording.size()) {
        call_error(L, "index is " + std::to_string(index) + "; expected 1 to " +
                          std::to_string(self.recording.size()) + ", the number of states");
    }
    return static_cast<int>(index - 1);
}

void seek(lua_State* L, RecordingObject* self, WorldRef world, std::int64_t index) {
    check_or_raise(L, self->recording.seek(world.world, to_state(L, *self, index)));
    adopt_state(L, world, 0);
}

physics::Result<void> cut(lua_State* L, RecordingObject* self, std::int64_t index) {
    return self->recording.cut(to_state(L, *self, index));
}

Pushed save(lua_State* L, RecordingObject* self) {
    physics::Snapshot bytes;
    check_or_raise(L, self->recording.save(bytes));
    return push_bytes(L, bytes);
}

physics::Result<void> load(lua_State* L, RecordingObject* self, std::string_view bytes) {
    const physics::Result<void> done = self->recording.load(as_bytes(bytes));
    if (done) charge_native_memory(L, self->recording.byte_count());
    return done;
}

constexpr std::array<std::string_view, 1> kReturnsBytes = {"string"};

constexpr Function kFunctions[] = {
    function<&record>(
        "record", "world", "",
        "Appends the state of a world as it is now: call it after each step, and once before the "
        "first."),
    function<&size>("size", "", "count", "How many states there are."),
    function<&byte_count>("byte_count", "", "bytes", "In memory, and about as much in a file."),
    function<&seek>(
        "seek", "world, index", "",
        "Puts a world into a state, from 1 to `size()`, bit for bit. Bodies that are there before and "
        "after keep their values and `data`; one that comes back is a new value with an empty table."),
    function<&cut>("cut", "index", "",
                   "Forgets the states from `index` on: to record another future from there."),
    function_pushing<&save>("save", "", "bytes", kReturnsBytes,
                            "All of it as a string with a version and a checksum, for `cairn.files.write`."),
    function<&load>(
        "load", "bytes", "",
        "Takes what `save` gave, here or on another machine, instead of what it holds. Bytes that are "
        "damaged or of another version are an error, and nothing changes."),
};

}  // namespace

int finalize_recording(lua_State* L) {
    object_at<RecordingObject>(L, 1)->~RecordingObject();
    return 0;
}

const Module kRecordingMethods = {
    "Recording",
    "What a world went through, state by state: to be shown again, and to be gone "
    "back into at any step. Each state is kept as its difference from the one before.",
    kFunctions, true};

}  // namespace cairn::scripting
