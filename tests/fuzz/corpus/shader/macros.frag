#define A B B
#define B A A C \
 D(A)
#define D(x) x x
void main() { /* open
