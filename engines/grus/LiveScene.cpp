#include <grus/LiveScene.hpp>

namespace yade {

namespace {

// YADE runs one scene at a time, and engines ask from the thread that runs it.
const Scene* liveScene = nullptr;
const LiveScene* live = nullptr;

}

const LiveScene* LiveScene::of(const Scene& scene) { return &scene == liveScene ? live : nullptr; }

LiveScene::Announcement::Announcement(const Scene& scene, const LiveScene& known) {
    liveScene = &scene;
    live = &known;
}

LiveScene::Announcement::~Announcement() { liveScene = nullptr; }

}
