#include "exhibits/jobs/sprite/sprite_table.h"

namespace vitrine::jobs {

const SpriteTable& spriteTable()
{
    static const SpriteTable table;
    return table;
}

}  // namespace vitrine::jobs
