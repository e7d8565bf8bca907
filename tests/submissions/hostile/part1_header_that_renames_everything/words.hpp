#define bounce mine
#define return throw
#define const
