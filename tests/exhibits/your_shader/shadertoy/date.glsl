// iDate: years after 2000, the day, and the hour. Months count from 0.
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    float hour = floor(iDate.w / 3600.0 + 0.001);
    fragColor = vec4(iDate.x - 2000.0, iDate.z + iDate.y, hour, 0.0) / 255.0;
}
