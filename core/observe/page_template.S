/* The page made in web/, as bytes of the program: `const char page_template[]`, ended by a NUL. */
        .section .rodata
        .global page_template
        .hidden page_template
page_template:
        .incbin PAGE_TEMPLATE_FILE
        .byte 0
        .section .note.GNU-stack,"",%progbits
