#include "scene/gltf_materials.h"

#include "scene/validate.h"

#include <algorithm>
#include <fmt/format.h>

namespace penumbra {

namespace {

std::optional<Rgb> colour(const JsonValue &owner, const char *key, std::size_t n_least, std::size_t n_most) {
    const auto values = owner.find(key);
    if (!values)
        return std::nullopt;
    if (const std::size_t n = values->size(); n < n_least || n > n_most)
        values->fail(fmt::format("has {} values; give red, green and blue{}", n, n_most > 3 ? ", and alpha" : ""));
    return Rgb(values->at(0).number(), values->at(1).number(), values->at(2).number());
}

double emissive_strength(const JsonValue &material) {
    const auto extensions = material.find("extensions");
    const auto extension = extensions ? extensions->find("KHR_materials_emissive_strength") : std::nullopt;
    const auto strength = extension ? extension->find("emissiveStrength") : std::nullopt;
    return strength ? strength->number() : 1;
}

} // namespace

GltfMaterials read_gltf_materials(const JsonValue &root, Skipped &skipped) {
    GltfMaterials out;
    const JsonValue list = root.list("materials");
    if (list.size() > most_materials)
        list.fail(fmt::format("has {} materials, more than {}; merge some", list.size(), most_materials));
    for (std::size_t i = 0; i < list.size(); ++i) {
        const JsonValue material = list.at(i);
        Material &m = out.materials.emplace_back();
        if (const auto name = material.find("name"))
            m.name = name->text(longest_name);
        m.exitance = colour(material, "emissiveFactor", 3, 3).value_or(Rgb::Zero()) * emissive_strength(material);
        const auto surface = material.find("pbrMetallicRoughness");
        const auto base = surface ? colour(*surface, "baseColorFactor", 3, 4) : std::nullopt;
        m.reflectance = base ? *base : m.exitance.maxCoeff() > 0 ? Rgb::Zero() : Rgb::Constant(0.5);
        out.is_grey.push_back(!base && !(m.exitance.maxCoeff() > 0));
        const auto two = material.find("doubleSided");
        out.double_sided.push_back(two && two->boolean());
        for (const char *texture : {"normalTexture", "occlusionTexture", "emissiveTexture"})
            if (material.find(texture))
                skipped.add(texture);
        for (const char *texture : {"baseColorTexture", "metallicRoughnessTexture"})
            if (surface && surface->find(texture))
                skipped.add(texture);
    }
    out.materials.emplace_back();
    out.double_sided.push_back(false);
    out.is_grey.push_back(true);
    return out;
}

} // namespace penumbra
