import js from "@eslint/js";

/** Names that are nowhere are the type checker's, which knows the browser's. */
export default [
  js.configs.recommended,
  {
    rules: {
      "no-undef": "off",
      curly: ["error", "multi-line"],
      eqeqeq: "error",
      "max-lines": ["error", 350],
      "max-lines-per-function": ["error", 60],
      "no-eval": "error",
      "no-implied-eval": "error",
      "no-param-reassign": "error",
      "no-shadow": "error",
      "no-var": "error",
      "no-restricted-properties": ["error", { property: "innerHTML" }, { property: "outerHTML" }],
      "no-restricted-globals": ["error", "fetch", "XMLHttpRequest", "WebSocket", "eval"],
      "prefer-const": "error",
      "prefer-template": "off",
    },
  },
];
