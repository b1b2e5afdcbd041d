#include "call_table.h"
#include "painted_images.h"

namespace rt {

namespace {

using Kind = ParameterKind;

constexpr Parameter kNode{"node", Kind::kNode, "The node."};
constexpr Parameter kSpecular{"specular", Kind::kColor, "{r,g,b} of the highlight."};
constexpr Parameter kExponent{"exponent", Kind::kNumber, "Phong exponent of the highlight.",
                              kNotNegative};
constexpr Range kPaintedSide{1.0, kMostPaintedSide, false, false};
constexpr Parameter kOwnWeight{"f", Kind::kNumber, "Weight of the object's own colour.", kUnit};

CallResult material(Call& call) {
    return call.scene.addMaterial({call.tuple(0), call.tuple(1), call.number(2)});
}

CallResult texture(Call& call) {
    TextureDesc desc;
    desc.image = call.scene.image(call.text(0), AssetRole::kTexture);
    desc.specular = call.tuple(1);
    desc.exponent = call.number(2);
    return call.scene.addTexture(desc);
}

bool startsWithFunction(const Arguments& in) {
    return in.isFunction(1);
}

CallResult paintedTexture(Call& call) {
    TextureDesc desc;
    const int side = call.given(3) ? static_cast<int>(call.number(3)) : 0;
    desc.image =
        call.scene.paintedImage(keepFunction(call.arguments().state(), Call::slot(0)), side);
    desc.specular = call.tuple(1);
    desc.exponent = call.number(2);
    return call.scene.addTexture(desc);
}

CallResult bumpmap(Call& call) {
    return call.scene.addBump(call.scene.image(call.text(0), AssetRole::kBump));
}

/// True for a node that has a surface; a group gets a warning, for it shows nothing itself.
bool hasSurface(Call& call, const char* what) {
    const NodeDesc& node = call.scene.node(call.object(0));
    if (node.geometry != kNone) return true;
    call.scene.warnOnce("group-appearance", std::string(what) + " is ignored: '" +
                                                printable(node.name, 64) + "' is a group");
    return false;
}

CallResult setMaterial(Call& call) {
    if (!hasSurface(call, "the material")) return {};
    call.scene.edit(call.object(0)).appearance.material = call.object(1);
    return {};
}

CallResult setTexture(Call& call) {
    if (!hasSurface(call, "the texture")) return {};
    call.scene.edit(call.object(0)).appearance.texture = call.object(1);
    return {};
}

CallResult setBumpmap(Call& call) {
    if (!hasSurface(call, "the bump map")) return {};
    call.scene.edit(call.object(0)).appearance.bump = call.object(1);
    return {};
}

CallResult setReflection(Call& call) {
    if (!hasSurface(call, "the reflection")) return {};
    call.scene.edit(call.object(0)).reflection = call.number(1);
    return {};
}

CallResult setRefraction(Call& call) {
    if (call.number(1) < 1.0) {
        call.scene.warnOnce("low-index", "index " + numberText(call.number(1)) +
                                             " is below 1: thinner than a vacuum");
    }
    if (!hasSurface(call, "the refraction")) return {};
    call.scene.edit(call.object(0)).refraction = RefractionDesc{call.number(1), call.number(2)};
    return {};
}

CallResult setFresnel(Call& call) {
    if (!hasSurface(call, "the Fresnel split")) return {};
    call.scene.edit(call.object(0)).fresnel = call.boolean(1);
    return {};
}

CallResult setAbsorption(Call& call) {
    if (!hasSurface(call, "the absorption")) return {};
    call.scene.edit(call.object(0)).absorption = call.tuple(1);
    return {};
}

std::vector<CallRow> makers() {
    return {
        {"material",
         "A Phong material.",
         {{{{"diffuse", Kind::kColor, "{r,g,b} of the matt part."}, kSpecular, kExponent},
           material}},
         "gr.material"},
        {"texture",
         "A material whose matt part comes from an image, or from a function of the script that is "
         "called once the script has ended, at the centres of the texels of the unit square.",
         {{{{"paint",
             Kind::kAny,
             "Gives the colour at (u, v): three numbers, a table of them, or one for grey.",
             {},
             false,
             {},
             "fun(u: number, v: number): number|gr.tuple, number?, number?"},
            kSpecular,
            kExponent,
            {"side", Kind::kWholeNumber, "Texels along a side; as many as are needed without it.",
             kPaintedSide, true}},
           paintedTexture,
           startsWithFunction},
          {{{"file", Kind::kText, "The image."}, kSpecular, kExponent}, texture}},
         "gr.texture"},
        {"bumpmap",
         "A tangent-space normal map, or a height map if the image has one channel.",
         {{{{"file", Kind::kText, "The image."}}, bumpmap}},
         "gr.bumpmap"},
    };
}

}  // namespace

std::vector<CallRow> appearanceCalls() {
    std::vector<CallRow> rows = makers();
    rows.push_back({"set_material",
                    "The node's own material.",
                    {{{kNode, {"material", Kind::kMaterial, "The material."}}, setMaterial}}});
    rows.push_back({"set_texture",
                    "The node's own texture, which replaces its material.",
                    {{{kNode, {"texture", Kind::kTexture, "The texture."}}, setTexture}}});
    rows.push_back({"set_bumpmap",
                    "The node's own bump map.",
                    {{{kNode, {"bump", Kind::kBump, "The bump map."}}, setBumpmap}}});
    rows.push_back({"set_reflection",
                    "Mirrors: colour = f own + (1-f) reflected.",
                    {{{kNode, kOwnWeight}, setReflection}}});
    rows.push_back(
        {"set_refraction",
         "Lets light through: colour = f own + (1-f) refracted.",
         {{{kNode, {"index", Kind::kNumber, "Index of refraction.", kPositive}, kOwnWeight},
           setRefraction}}});
    rows.push_back({"set_fresnel",
                    "Splits what is refracted into F reflected + (1-F) refracted.",
                    {{{kNode, {"on", Kind::kBoolean, "Whether to split."}}, setFresnel}}});
    rows.push_back(
        {"set_absorption",
         "Colours what shines through: exp(-absorption distance) is left of it.",
         {{{kNode, {"absorption", Kind::kTuple, "{r,g,b}, per unit of the world.", kNotNegative}},
           setAbsorption}}});
    return rows;
}

}  // namespace rt
