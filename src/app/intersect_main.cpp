// intersect KIND [--time] [--isa NAME]: answers rays against single primitives, one question a line
// on stdin, by the kernel that a render runs. For testing; the format is in
// tests/vectors/README.md.
#include "intersect/shape_kinds.h"
#include "rt/render/kernel_choice.h"
#include "rt/trace/trace_kernel.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace rt;

constexpr int kExitBadInput = 2;

struct Question {
    Shape shape;
    Transform transform;
    Ray ray;
    Interval range;
};

Question readQuestion(const ShapeKind& kind, const std::string& line) {
    Words in(line);
    const std::string name = in.word();
    Question question{kind.read(in), {}, {}, {}};
    if (name == "affine" && !Transform::make(in.map(), question.transform)) {
        throw std::invalid_argument("the map has no finite inverse");
    }
    question.ray.origin = in.vec();
    question.ray.direction = in.vec();
    if (question.ray.direction == Vec3(0.0)) throw std::invalid_argument("a direction of zero");
    if (kind.hasMinimum) question.range.min = in.number();
    in.expectEnd();
    return question;
}

std::vector<Question> readQuestions(const ShapeKind& kind, std::istream& in) {
    std::vector<Question> questions;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        const std::size_t start = line.find_first_not_of(" \t\r");
        if (start == std::string::npos || line[start] == '#') continue;
        try {
            questions.push_back(readQuestion(kind, line));
        } catch (const std::exception& error) {
            throw std::invalid_argument("line " + std::to_string(number) + ": " + error.what());
        }
    }
    return questions;
}

void printAnswers(const TraceKernel& kernel, const std::vector<Question>& questions) {
    for (const Question& q : questions) {
        PrimitiveHit hit;
        Vec3 n;
        if (kernel.intersectShape(q.shape, q.transform, q.ray, q.range, hit, n)) {
            std::printf("%a %a %a %a\n", hit.t, n.x, n.y, n.z);
        } else {
            std::puts("miss");
        }
    }
}

/// Processor time of this thread: what else the machine does counts less.
double threadNanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// Median over several passes of the time for one question.
double nanosecondsPerRay(const TraceKernel& kernel, const std::vector<Question>& questions) {
    constexpr int kPasses = 11;
    constexpr std::size_t kRaysPerPass = 200000;
    const std::size_t rounds = std::max<std::size_t>(1, kRaysPerPass / questions.size());
    std::vector<double> passes;
    volatile double sink = 0.0;
    for (int pass = 0; pass < kPasses; ++pass) {
        const double start = threadNanoseconds();
        double sum = 0.0;
        for (std::size_t round = 0; round < rounds; ++round) {
            for (const Question& q : questions) {
                PrimitiveHit hit;
                Vec3 n;
                if (kernel.intersectShape(q.shape, q.transform, q.ray, q.range, hit, n)) {
                    sum += hit.t + n.x;
                }
            }
        }
        sink = sink + sum;
        const double spent = threadNanoseconds() - start;
        passes.push_back(spent / static_cast<double>(rounds * questions.size()));
    }
    std::nth_element(passes.begin(), passes.begin() + kPasses / 2, passes.end());
    return passes[kPasses / 2];
}

struct Arguments {
    const ShapeKind* kind = nullptr;
    bool time = false;
    std::string isa;  ///< empty: the fastest
};

bool parse(int argc, char** argv, Arguments& out) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--time") {
            out.time = true;
        } else if (word == "--isa" && i + 1 < argc) {
            out.isa = argv[++i];
        } else {
            const ShapeKind* const kind = shapeKindNamed(word);
            if (!kind || out.kind) return false;
            out.kind = kind;
        }
    }
    return out.kind != nullptr;
}

int usage() {
    std::fputs("usage: intersect KIND [--time] [--isa NAME] < questions; KIND is one of", stderr);
    for (const ShapeKind& kind : shapeKinds()) std::fprintf(stderr, " %s", kind.name);
    std::fputs("\n", stderr);
    return kExitBadInput;
}

int run(const Arguments& arguments) {
    const TraceKernel& kernel = chooseKernel(arguments.isa);
    const std::vector<Question> questions = readQuestions(*arguments.kind, std::cin);
    printAnswers(kernel, questions);
    if (arguments.time && !questions.empty()) {
        std::fprintf(stderr, "ns_per_ray %.1f\n", nanosecondsPerRay(kernel, questions));
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    if (!parse(argc, argv, arguments)) return usage();
    try {
        return run(arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "intersect: %s\n", error.what());
        return kExitBadInput;
    }
}
