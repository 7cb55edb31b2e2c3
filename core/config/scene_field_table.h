/* The table of the keys of a parameter that varies over the membrane (scene_field.h): what reads, prints and
 * describes it is made from it. */
#ifndef CAPSELLA_CONFIG_SCENE_FIELD_TABLE_H
#define CAPSELLA_CONFIG_SCENE_FIELD_TABLE_H

#include "config/scene_field.h"

typedef enum { ITEM_NUMBER, ITEM_QUANTITY, ITEM_POINT, ITEM_FILE, ITEM_HASH, ITEM_SEED } ItemType;
typedef enum { ITEM_REQUIRED, ITEM_OPTIONAL } ItemNeed;

typedef struct {
  const char *key;
  ItemType type;
  ItemNeed need;
  size_t offset; /* in SceneField */
  bool positive; /* the number is above 0; otherwise at least 0 */
  const char *meaning;
} FieldItem;

enum { MAX_ITEMS = 4 };

/* `opening` is the key by which a kind is known: the first item, or for scatter a mapping of `items`, beside
 * which stand the items of SCENE_FIELD_SCATTER. */
typedef struct {
  const char *opening;
  bool is_scatter;
  FieldItem items[MAX_ITEMS + 1]; /* ends with a key of NULL */
  const char *meaning;
} FieldForm;

extern const FieldForm SCENE_FIELD_FORMS[FIELD_KINDS];
extern const FieldItem SCENE_FIELD_SCATTER[]; /* ends with a key of NULL */

#endif
