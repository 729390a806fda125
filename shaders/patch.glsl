// A patch's record. Local coordinates have corner 0 as their origin and the patch's size as their unit, so that single
// precision is spent on the patch and not on where it lies.
uniform samplerBuffer patches;

const int patch_texels = 8;
// 0: corner 0 of the quad whose parameters the polynomial has, in the plane | size | surface
// 1: local corners 1, 2
// 2: local corner 3 | order | first coefficient
// 3: mean radiosity | 1 where the quad is a box about the patch
// 4 to 7: corner radiosities, averaged over the patches that meet there

vec4 patch_texel(int index, int k) { return texelFetch(patches, patch_texels * index + k); }
