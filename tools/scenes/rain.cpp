// Ragdolls rain on five storeys; once there are 1,000, the oldest make room for new ones.
#include <array>
#include <vector>

#include "ragdoll.h"
#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;

namespace {

constexpr int kStoreys = 5;
constexpr int kColumns = 40;
constexpr int kGroupSize = 5;
constexpr int kPeriod_steps = 8;

struct Group {
    std::array<Ragdoll, kGroupSize> figures;
    bool is_there = false;
};

class Cloud {
  public:
    // One more column in each storey.
    void pour(Engine& engine) {
        for (int storey = 0; storey < kStoreys; ++storey) {
            Group& group = groups_[static_cast<std::size_t>(storey * kColumns + next_)];
            if (group.is_there) remove(engine, group);
            int number = (storey * kColumns + next_) * kGroupSize;
            double x_m = -125 + 6.25 * (next_ + 0.5);
            for (Ragdoll& figure : group.figures) {
                figure = add_ragdoll(engine, {x_m, 40.0 + 45 * storey}, ++number);
                x_m += 0.5;
            }
            group.is_there = true;
        }
        next_ = (next_ + 1) % kColumns;
    }

  private:
    static void remove(Engine& engine, const Group& group) {
        for (const Ragdoll& figure : group.figures) {
            for (const BodyRef bone : figure) engine.remove_body(bone);
        }
    }

    std::vector<Group> groups_{kStoreys * kColumns};
    int next_ = 0;
};

}  // namespace

Scene rain() {
    return {.name = "rain",
            .summary = "up to 1,000 ragdolls fall on five floors, 25 come and 25 go every 8 steps",
            .steps = 1000,
            .build = [](Engine& engine) -> BeforeStep {
                const BodyRef ground = engine.add_body({.type = BodyType::Static});
                for (int storey = 0; storey < kStoreys; ++storey) {
                    for (int i = 0; i <= 500; ++i) {
                        engine.add_shape(
                            ground,
                            Box{0.25f,
                                0.25f,
                                {-125 + 0.5f * static_cast<float>(i), 45.0f * static_cast<float>(storey)}},
                            {});
                    }
                }
                return [cloud = Cloud()](Engine& world, int step, Findings&) mutable {
                    if (step % kPeriod_steps == 0) cloud.pour(world);
                };
            }};
}

}  // namespace cairn::bench
