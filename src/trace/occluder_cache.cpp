#include "occluder_cache.h"

namespace rt {

bool OccluderCache::Entry::covers(const ShadowHull& other) const {
    const double room = hull.fromRadius - other.fromRadius;
    const Vec3 step = other.from - hull.from;
    if (!(room > 0.0 && glm::dot(step, step) <= room * room)) return false;
    const double roomThere = hull.toRadius - other.toRadius;
    const Vec3 stepThere = other.to - hull.to;
    return roomThere >= 0.0 && glm::dot(stepThere, stepThere) <= roomThere * roomThere;
}

OccluderCache::Entry& OccluderCache::entryFor(Index light, std::uint32_t path) {
    for (Entry& entry : entries_) {
        if (entry.light == light && entry.path == path) return entry;
    }
    if (entries_.size() < kMostEntries) return entries_.emplace_back(Entry{light, path});
    Entry& entry = entries_[next_];
    next_ = (next_ + 1) % kMostEntries;
    entry = {light, path};
    return entry;
}

Occluders OccluderCache::occludersIn(const RenderScene& scene, const ShadowHull& hull, Index light,
                                     std::uint32_t path, Index except) {
    Entry& entry = entryFor(light, path);
    if (entry.reach < kLeastReach) return rt::occludersIn(scene, hull, except);
    if (!entry.covers(hull)) {
        entry.hull = hull;
        entry.hull.fromRadius *= entry.reach;
        // The far end moves by the step to the side, and by as much along the light.
        if (hull.parallel) entry.hull.toRadius += 2.0 * (entry.hull.fromRadius - hull.fromRadius);
        if (!candidatesIn(scene, entry.hull, kMostCandidates, entry.candidates)) {
            entry.reach /= 4.0;
            entry.hull.fromRadius = 0.0;
            return rt::occludersIn(scene, hull, except);
        }
    }
    Occluders occluders;
    for (const Index item : entry.candidates) {
        if (item != except && meetsHull(scene, hull, item)) occluders.add(item);
    }
    return occluders;
}

}  // namespace rt
