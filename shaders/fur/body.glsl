// One body and its coat: mirrored by FurBody in exhibits/fur/coat.h. Body space: metres, turns with the body.
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"
#include "lib/hash.glsl"
#include "lib/strand.glsl"

struct FurBody {
    mat4 worldFromBody;
    mat4 bodyFromWorld;
    vec4 pull;       // xyz: where tips are drawn, strand lengths, body space; w: drawn skin over skin at rest
    vec4 turn;       // what the tips lag behind the body's turning: unit quaternion, body space
    vec4 wind;       // xyz: strand lengths, body space; w: seconds times gusts per second, wrapped
    vec4 coat;       // x: strand length, metres; y: cell size, metres; z: radius of a strand, metres; w: least length, 0 to 1
    vec4 rootColor;  // w: number of the body, from 1
    vec4 tipColor;   // w: number of planes
    vec4 shells;     // x: how many, need not be whole; y: samples between two shells; z: seed; w: 1 when inner shells come first
    vec4 planes[4];  // xyz: unit normal, body space, away from what presses; w: its distance from the body's origin
    vec4 spine;      // x: length of its straight half along x; y: radius of its ring about y; z: radius around that, metres; w: first shell drawn
};

// Height of shell `i`, the outermost being 0 and the skin the last, before `distanceAttenuation`.
float shellHeight(float i, float count)
{
    return count > 1.0 ? max(1.0 - i / (count - 1.0), 0.0) : 0.0;
}
