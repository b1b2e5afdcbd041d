// The tree beside Embree 3 on one thread, interleaved in one run: medians of rounds.
//   accel_bench [--mesh 20k|500k|4M|room]... [--isa baseline|avx2|avx512]... [--embree CONFIG]
//               [--rays primary|shadow|reflection|random]... [--rounds N] [--size N] [--json FILE]
// Single rays and packets on each instruction set asked for (avx2 and avx512 where the processor
// has them), against Embree's single rays, robust and fast, medium and high quality, the better of
// each. CONFIG goes to rtcNewDevice, e.g. max_isa=avx2; Embree chooses by itself otherwise.
// "disagree" is the part of the rays for which Embree finds another nearest hit, single precision
// allowed for; above 1e-3 the exit code is 1.
#include "accel_meshes.h"
#include "rt/accel/mesh_tree.h"
#include "rt/geometry/triangle.h"
#include "rt/render/kernel_choice.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <ctime>
#include <fstream>
#include <functional>
#include <memory>

namespace rt::bench {
namespace {

constexpr int kBuildThreads = 2;

double secondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// CPU time of this thread: what else the machine does counts less.
double threadSecondsOf(const std::function<std::size_t()>& work) {
    const auto now = [] {
        timespec time;
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

std::atomic<std::int64_t> embreeBytes{0};

bool countBytes(void*, ssize_t bytes, bool) {
    embreeBytes += bytes;
    return true;
}

/// An Embree scene of one mesh.
class EmbreeScene {
  public:
    EmbreeScene(RTCDevice device, const TriangleMesh& mesh, RTCSceneFlags flags,
                RTCBuildQuality quality)
        : scene_(rtcNewScene(device)) {
        rtcSetSceneFlags(scene_, flags);
        rtcSetSceneBuildQuality(scene_, quality);
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* positions = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), mesh.positions.size()));
        for (const Vec3& p : mesh.positions) {
            for (int axis = 0; axis < 3; ++axis) *positions++ = static_cast<float>(p[axis]);
        }
        void* indices =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(Index), mesh.triangles.size());
        std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * 3 * sizeof(Index));
        rtcSetGeometryBuildQuality(geometry, quality);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        const std::int64_t before = embreeBytes;
        buildSeconds = secondsOf([&] { rtcCommitScene(scene_); });
        bytes = embreeBytes - before;
    }
    ~EmbreeScene() { rtcReleaseScene(scene_); }
    EmbreeScene(const EmbreeScene&) = delete;

    std::size_t trace(const RaySet& set) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        std::size_t hits = 0;
        for (const Ray& ray : set.rays) {
            RTCRayHit query = queryOf(ray, set.tMin, set.tMax);
            if (set.anyHit) {
                rtcOccluded1(scene_, &context, &query.ray);
                hits += query.ray.tfar < 0.0f;
            } else {
                rtcIntersect1(scene_, &context, &query);
                hits += query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
            }
        }
        return hits;
    }

    /// The t of the nearest hit; infinite where nothing is hit.
    double nearest(const Ray& ray, double tMin, double tMax) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query = queryOf(ray, tMin, tMax);
        rtcIntersect1(scene_, &context, &query);
        return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kInfinity : double(query.ray.tfar);
    }

    double buildSeconds = 0.0;
    std::int64_t bytes = 0;

  private:
    static RTCRayHit queryOf(const Ray& ray, double tMin, double tMax) {
        RTCRayHit query{};
        RTCRay& r = query.ray;
        r.org_x = float(ray.origin.x), r.org_y = float(ray.origin.y);
        r.org_z = float(ray.origin.z);
        r.dir_x = float(ray.direction.x), r.dir_y = float(ray.direction.y);
        r.dir_z = float(ray.direction.z);
        r.tnear = float(tMin), r.tfar = float(tMax);
        r.mask = ~0u;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        return query;
    }

    RTCScene scene_;
};

std::size_t traceSingly(const MeshQueries& mesh, const MeshTree& tree, const RaySet& set) {
    std::size_t hits = 0;
    const Interval range{set.tMin, set.tMax};
    for (const Ray& ray : set.rays) {
        PrimitiveHit hit;
        hits += set.anyHit ? mesh.anyHit(tree, ray, range) : mesh.closestHit(tree, ray, range, hit);
    }
    return hits;
}

std::size_t traceInPackets(const MeshQueries& mesh, const MeshTree& tree, const RaySet& set) {
    constexpr std::size_t kBatch = 64;
    const std::vector<Interval> ranges(kBatch, {set.tMin, set.tMax});
    PrimitiveHit found[kBatch];
    bool met[kBatch];
    std::size_t hits = 0;
    for (std::size_t first = 0; first < set.rays.size(); first += kBatch) {
        const std::size_t count = std::min(kBatch, set.rays.size() - first);
        const std::span some(set.rays.data() + first, count);
        const std::span someRanges(ranges.data(), count);
        if (set.anyHit) {
            mesh.anyHits(tree, some, someRanges, {met, count});
            hits += static_cast<std::size_t>(std::count(met, met + count, true));
        } else {
            mesh.closestHits(tree, some, someRanges, {found, count});
            for (std::size_t i = 0; i < count; ++i) hits += found[i].part != kNone;
        }
    }
    return hits;
}

/// The part of the rays for which Embree, an oracle that shares no code, and the tree disagree: one
/// of them misses, or their t differ by more than single precision explains.
double disagreement(const MeshTree& tree, const EmbreeScene& embree, const RaySet& set) {
    constexpr double kTolerance = 1e-4;
    std::size_t different = 0;
    for (const Ray& ray : set.rays) {
        PrimitiveHit hit;
        const bool isHit = tree.closestHit(ray, {set.tMin, set.tMax}, hit);
        const double other = embree.nearest(ray, set.tMin, set.tMax);
        if (isHit != (other < kInfinity))
            ++different;
        else if (isHit && !(std::fabs(hit.t - other) <= kTolerance * (1.0 + hit.t)))
            ++different;
    }
    return double(different) / double(set.rays.size());
}

struct Settings {
    std::vector<std::string> meshes{"20k", "500k", "4M", "room"};
    std::vector<std::string> isas;
    std::vector<std::string> rays;
    std::string embree;
    int rounds = 5;
    int size = 512;
    std::string json;
};

struct Subject {
    std::string name;
    TriangleMesh mesh;
    Ray view;
};

Subject makeSubject(const std::string& name) {
    const Ray outside{{0.4, 0.9, 2.6}, {-0.4, -0.9, -2.6}};
    if (name == "20k") return {name, Icosphere::make(32), outside};
    if (name == "500k") return {name, Icosphere::make(158), outside};
    if (name == "4M") return {name, Icosphere::make(447), outside};
    if (name == "room") return {name, Room::make(), {{-18, 5, 9}, {1.0, -0.15, -0.5}}};
    throw std::invalid_argument("unknown mesh " + name + "; there are 20k, 500k, 4M, room");
}

/// Seconds of several tracers, taken in turn: [tracer][round].
using Times = std::vector<std::vector<double>>;

Times race(const std::vector<std::function<std::size_t()>>& tracers, int rounds) {
    Times seconds(tracers.size());
    for (int round = -1; round < rounds; ++round) {
        for (std::size_t i = 0; i < tracers.size(); ++i) {
            const double s = threadSecondsOf(tracers[i]);
            if (round >= 0) seconds[i].push_back(s);
        }
    }
    return seconds;
}

/// How many times as fast `one` is as `other`: the median over rounds, whose times were taken
/// one right after the other.
double timesAsFast(const std::vector<double>& one, const std::vector<double>& other) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < one.size(); ++i) ratios.push_back(other[i] / one[i]);
    return median(ratios);
}

/// Embree's four scenes of a mesh: robust and fast, at two qualities.
struct EmbreeScenes {
    EmbreeScenes(RTCDevice device, const TriangleMesh& mesh) {
        for (const RTCSceneFlags flags : {RTC_SCENE_FLAG_ROBUST, RTC_SCENE_FLAG_NONE}) {
            for (const RTCBuildQuality quality :
                 {RTC_BUILD_QUALITY_MEDIUM, RTC_BUILD_QUALITY_HIGH}) {
                scenes.push_back(std::make_unique<EmbreeScene>(device, mesh, flags, quality));
            }
        }
    }
    std::vector<std::unique_ptr<EmbreeScene>> scenes;
};

/// Ratios to Embree, gathered over all cells.
struct Ratios {
    std::vector<double> values;

    void add(double ratio) { values.push_back(ratio); }
    double least() const { return *std::min_element(values.begin(), values.end()); }
    double mean() const {
        double sum = 0.0;
        for (const double ratio : values) sum += std::log(ratio);
        return std::exp(sum / double(values.size()));
    }
};

/// One instruction set's ratios, by what they compare.
struct Score {
    Ratios robust, fast, packets;  ///< packets: of primary and shadow rays, to robust single rays
};

constexpr double kMostDisagreement = 1e-3;

nlohmann::json benchRays(const RaySet& set, const MeshTree& tree, const EmbreeScenes& embree,
                         const std::vector<const TraceKernel*>& kernels, int rounds,
                         std::vector<Score>& scores, bool& agrees) {
    std::vector<std::function<std::size_t()>> tracers;
    for (const auto& scene : embree.scenes) tracers.push_back([&] { return scene->trace(set); });
    for (const TraceKernel* kernel : kernels) {
        tracers.push_back([&, kernel] { return traceSingly(kernel->mesh, tree, set); });
        tracers.push_back([&, kernel] { return traceInPackets(kernel->mesh, tree, set); });
    }
    const Times seconds = race(tracers, rounds);
    const auto rate = [&](std::size_t tracer) {
        return double(set.rays.size()) / median(seconds[tracer]) / 1e6;
    };
    const std::size_t robust = rate(0) > rate(1) ? 0 : 1, fast = rate(2) > rate(3) ? 2 : 3;
    fmt::print("  {:<11}{:>7.2f}{:>7.2f}", set.name, rate(robust), rate(fast));
    const double apart = disagreement(tree, *embree.scenes[robust], set);
    agrees = agrees && apart <= kMostDisagreement;
    nlohmann::json result{{"rays", set.rays.size()},         {"hits", tracers.back()()},
                          {"embreeHits", tracers.front()()}, {"disagreement", apart},
                          {"embreeRobust", rate(robust)},    {"embreeFast", rate(fast)}};
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        const std::size_t single = 4 + 2 * i, packets = 5 + 2 * i;
        const double toRobust = timesAsFast(seconds[single], seconds[robust]);
        const double toFast = timesAsFast(seconds[single], seconds[fast]);
        const double packetsToRobust = timesAsFast(seconds[packets], seconds[robust]);
        Score& score = scores[i];
        score.robust.add(toRobust);
        score.fast.add(toFast);
        if (set.name == "primary" || set.name == "shadow") score.packets.add(packetsToRobust);
        fmt::print(" |{:>7.2f}{:>6.2f}{:>6.2f} {:>7.2f}{:>6.2f}", rate(single), toRobust, toFast,
                   rate(packets), packetsToRobust);
        result[kernels[i]->name] = {
            {"single", rate(single)},   {"nsPerRay", 1e3 / rate(single)},
            {"toRobust", toRobust},     {"toFast", toFast},
            {"packets", rate(packets)}, {"packetsToRobust", packetsToRobust}};
    }
    fmt::print("   {:.0e}\n", apart);
    std::fflush(stdout);
    return result;
}

nlohmann::json benchMesh(const Subject& subject, RTCDevice device,
                         const std::vector<const TraceKernel*>& kernels, const Settings& settings,
                         std::vector<Score>& scores, bool& agrees) {
    const TriangleMesh& mesh = subject.mesh;
    const double triangles = double(mesh.triangles.size());
    MeshTree tree;
    const double first = secondsOf([&] { tree = MeshTree::build(mesh, kBuildThreads); });
    const EmbreeScenes embree(device, mesh);
    tree = {};
    const double again = secondsOf([&] { tree = MeshTree::build(mesh, kBuildThreads); });
    const double build = std::min(first, again);
    const EmbreeScene& medium = *embree.scenes[0];
    const EmbreeScene& high = *embree.scenes[3];
    fmt::print(
        "\n{} ({} triangles): build {:.3f} s, {:.1f} bytes a triangle; Embree robust {:.3f} s, "
        "{:.1f} bytes; fast, high {:.3f} s, {:.1f} bytes\n  {:<11}{:>14}",
        subject.name, mesh.triangles.size(), build, double(tree.bytes()) / triangles,
        medium.buildSeconds, double(medium.bytes) / triangles, high.buildSeconds,
        double(high.bytes) / triangles, "Mrays/s", "robust   fast");
    for (const TraceKernel* kernel : kernels) {
        fmt::print(" |{:>8} /rob /fast packets  /rob", kernel->name);
    }
    fmt::print("   disagree\n");
    nlohmann::json result{{"triangles", mesh.triangles.size()},
                          {"buildSeconds", build},
                          {"bytesPerTriangle", double(tree.bytes()) / triangles},
                          {"embreeBuildSeconds", medium.buildSeconds},
                          {"embreeBytesPerTriangle", double(medium.bytes) / triangles},
                          {"embreeHighBuildSeconds", high.buildSeconds},
                          {"embreeHighBytesPerTriangle", double(high.bytes) / triangles}};
    const auto isWanted = [&](const std::string& name) {
        const auto& names = settings.rays;
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const RaySet& set : makeRays(mesh, tree, subject.view, settings.size)) {
        if (!isWanted(set.name)) continue;
        result[set.name] = benchRays(set, tree, embree, kernels, settings.rounds, scores, agrees);
    }
    return result;
}

/// Moeller and Trumbore's test (JGT 2(1), 1997) in double, as the plain measure.
bool moellerTrumbore(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c, Interval range,
                     PrimitiveHit& hit) {
    const Vec3 e1 = b - a, e2 = c - a;
    const Vec3 p = glm::cross(ray.direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant == 0.0) return false;
    const double inverse = 1.0 / determinant;
    const Vec3 s = ray.origin - a;
    const double u = glm::dot(s, p) * inverse;
    if (!(u >= 0.0 && u <= 1.0)) return false;
    const Vec3 q = glm::cross(s, e1);
    const double v = glm::dot(ray.direction, q) * inverse;
    if (!(v >= 0.0 && u + v <= 1.0)) return false;
    const double t = glm::dot(e2, q) * inverse;
    if (!range.contains(t)) return false;
    hit = {t, {1.0 - u - v, u, v}, 0};
    return true;
}

nlohmann::json benchTriangle(int rounds) {
    std::mt19937_64 random(3);
    std::vector<std::array<Vec3, 3>> triangles(1024);
    std::vector<Ray> rays(256);
    for (auto& corners : triangles) {
        const Vec3 centre = 2.0 * unitVector(random);
        for (Vec3& corner : corners) corner = centre + unitVector(random);
    }
    for (Ray& ray : rays) ray = {0.5 * unitVector(random), unitVector(random)};
    const auto each = [&](auto&& prepare, auto&& test) {
        std::size_t hits = 0;
        for (const Ray& ray : rays) {
            const auto prepared = prepare(ray);
            for (const auto& c : triangles) {
                PrimitiveHit hit;
                hits += test(prepared, c[0], c[1], c[2], Interval{}, hit);
            }
        }
        return hits;
    };
    const Times both =
        race({[&] {
                  return each([](const Ray& ray) { return TriangleRay(ray); },
                              [](const TriangleRay& ray, const Vec3& a, const Vec3& b,
                                 const Vec3& c, Interval range, PrimitiveHit& hit) {
                                  return intersectTriangle(ray, a, b, c, range, hit);
                              });
              },
              [&] { return each([](const Ray& ray) { return ray; }, moellerTrumbore); }},
             rounds);
    const double tests = double(rays.size() * triangles.size());
    const double ours = 1e9 * median(both[0]) / tests, theirs = 1e9 * median(both[1]) / tests;
    fmt::print(
        "\none triangle, scalar: {:.2f} ns; Moeller-Trumbore in double {:.2f} ns; ratio {:.2f}\n",
        ours, theirs, 1.0 / timesAsFast(both[0], both[1]));
    return {{"ns", ours}, {"moellerTrumboreNs", theirs}};
}

Settings parse(int count, char** arguments) {
    Settings settings;
    std::vector<std::string> meshes;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        const auto value = [&] {
            if (++i == count) throw std::invalid_argument(word + " needs a value");
            return std::string(arguments[i]);
        };
        if (word == "--mesh")
            meshes.push_back(value());
        else if (word == "--rounds")
            settings.rounds = std::stoi(value());
        else if (word == "--size")
            settings.size = std::stoi(value());
        else if (word == "--json")
            settings.json = value();
        else if (word == "--rays")
            settings.rays.push_back(value());
        else if (word == "--isa")
            settings.isas.push_back(value());
        else if (word == "--embree")
            settings.embree = value();
        else
            throw std::invalid_argument("unknown option " + word);
    }
    if (!meshes.empty()) settings.meshes = meshes;
    return settings;
}

std::vector<const TraceKernel*> chooseKernels(const std::vector<std::string>& names) {
    std::vector<const TraceKernel*> kernels;
    for (const std::string& name : names) kernels.push_back(&chooseKernel(name));
    if (names.empty()) kernels.assign(availableKernels().begin() + 1, availableKernels().end());
    if (kernels.empty()) kernels.push_back(availableKernels().front());
    return kernels;
}

bool run(const Settings& settings) {
    bool agrees = true;
    const std::vector<const TraceKernel*> kernels = chooseKernels(settings.isas);
    fmt::print("{} x {} rays, medians of {} rounds; Embree {}\n", settings.size, settings.size,
               settings.rounds, settings.embree.empty() ? "as it chooses" : settings.embree);
    nlohmann::json report{{"size", settings.size}, {"rounds", settings.rounds}};
    report["triangle"] = benchTriangle(4 * settings.rounds + 1);
    const std::string config = fmt::format("threads={},{}", kBuildThreads, settings.embree);
    const RTCDevice device = rtcNewDevice(config.c_str());
    rtcSetDeviceMemoryMonitorFunction(device, countBytes, nullptr);
    std::vector<Score> scores(kernels.size());
    for (const std::string& name : settings.meshes) {
        report["meshes"][name] =
            benchMesh(makeSubject(name), device, kernels, settings, scores, agrees);
    }
    rtcReleaseDevice(device);
    fmt::print("\n");
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        for (const auto& [what, ratios] :
             {std::pair{"single rays to robust", &scores[i].robust},
              std::pair{"single rays to fast", &scores[i].fast},
              std::pair{"coherent packets to robust", &scores[i].packets}}) {
            fmt::print("{:<9}{:<28} least {:.2f}, geometric mean {:.2f}\n", kernels[i]->name, what,
                       ratios->least(), ratios->mean());
            report["summary"][kernels[i]->name][what] = {{"least", ratios->least()},
                                                         {"mean", ratios->mean()}};
        }
    }
    if (!settings.json.empty()) std::ofstream(settings.json) << report.dump(2) << '\n';
    return agrees;
}

}  // namespace
}  // namespace rt::bench

int main(int count, char** arguments) {
    try {
        return rt::bench::run(rt::bench::parse(count, arguments)) ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "accel_bench: {}\n", error.what());
        return 2;
    }
}
