#pragma once

#include "api/operation.hpp"

namespace tuftwave::server {

/// GET /v1/limits: what may be asked for.
Answer get_limits(const Request& request, const Context& context);

/// GET /v1/version: which Tuftwave this is.
Answer get_version(const Request& request, const Context& context);

/// GET /openapi.yaml: the contract.
Answer get_openapi(const Request& request, const Context& context);

/// GET /docs: the contract as a page, and the files of that page below it.
Answer get_docs(const Request& request, const Context& context);
Answer get_docs_file(const Request& request, const Context& context);

}  // namespace tuftwave::server
