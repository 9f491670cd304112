// The table of scenes.
#include "scene.h"

namespace cairn::bench {

std::span<const Scene> all_scenes() {
    static const std::vector<Scene> scenes = [] {
        std::vector<Scene> list{compounds(),     joint_grid(),   junkyard(),    large_pyramid(),
                                many_pyramids(), rain(),         smash(),       spinner(),
                                tumbler(),       washer(),       chain_1000(),  ragdoll_pile_200(),
                                vehicles_100(),  bridge_field(), settled_10k(), falling_1k(),
                                query_mix()};
        for (const int thousands : {1, 2, 5, 10, 20, 50, 100}) list.push_back(scale(1000 * thousands));
        return list;
    }();
    return scenes;
}

}  // namespace cairn::bench
